// Parses the command line into options.
#pragma once

#include <string>
#include <variant>

#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/options.hpp"

namespace kerf::program {

// Help or version was asked for (text for standard output), or the command line is wrong (text for
// standard error).
struct Leave {
  ExitStatus status = ExitStatus::done;
  std::string text;
};

std::variant<Options, Leave> parse_options(int argc, const char* const* argv);

}  // namespace kerf::program
