// The check of a whole program before anything moves.
#pragma once

#include <cstdint>
#include <string>

#include <kerf/check.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

struct CheckPassOptions {
  double max_time_s;        // as CheckBounds
  std::uint64_t max_moves;  // the same
  bool shows_progress;
  bool syntax_only;
  bool starts_at_first_places;  // as CheckBounds
};

// check_program() over the file, or check_syntax(). Ends early, and then means nothing, when a stop
// is requested. Error: the file cannot be read.
tl::expected<CheckReport, std::string> check_pass(ProgramFile& file,
                                                  const MachineSettings& settings,
                                                  const KernelOptions& kernel_options,
                                                  const CheckPassOptions& options);

}  // namespace kerf::program
