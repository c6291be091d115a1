// The options of each command, with their help.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "profiles/profile.hpp"
#include "programs/kerf/options.hpp"

namespace kerf::program {

// What the options of all commands are read into; the words mean something once all are there
// (option_parser).
struct OptionWords {
  Options options;
  std::string profile{name_of(profiles::kDefaultProfile)};
  std::string block_delete;   // empty: not given
  std::string explain_speed;  // the same
  std::string max_time;       // the same
  std::string start;          // the same
  std::string g54;            // the same
  std::string max_trace;      // the same
  std::string trace_from;     // the same
  std::string trace_to;       // the same
  std::string measured;       // the same
  std::string from_line;      // the same
};

CLI::App* add_command(CLI::App& app, Subcommand command, const std::string& description,
                      OptionWords& words);

CLI::App* add_tick_cost(CLI::App& app, OptionWords& words);

}  // namespace kerf::program
