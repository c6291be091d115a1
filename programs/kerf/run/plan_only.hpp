// A plan without ticks: how long a program takes and how far it goes.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <kerf/kernel.hpp>
#include <tl/expected.hpp>

#include "diagnostics/diagnostic.hpp"
#include "kernel/plan_check.hpp"
#include "lookahead/planner.hpp"
#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/io/progress.hpp"
#include "programs/kerf/run/block_watch.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::program {

struct PlannedProgram {
  PlanTotals totals{};
  smoothing::PathDeviation deviation{};
  std::vector<PathControlUse> path_controls{};
  PlanWaits waits{};
  std::vector<diagnostics::Diagnostic> errors{};  // the plan ends before them
  std::optional<RunFault> fault{};                // the plan ends there
  std::optional<std::uint32_t> too_long_at_line;  // the plan ends there
};

struct PlanOrder {
  const MachineSettings& settings;
  const KernelOptions& options;
  double max_time_s;
};

// Preconditions: check_program() found no error; the file is rewound. Memory does not grow with the
// length of the program, and the work not with its time. Ends early when a stop is requested.
// Error: the file cannot be read. watch: called for everything that is read and planned.
//
// A run sends a cruise in short parts, whose times are rounded: where a cruise takes hours, it may
// end a tick beside what is planned here.
tl::expected<PlannedProgram, std::string> plan_only(ProgramFile& file, const PlanOrder& order,
                                                    Progress& progress, BlockWatch& watch);

}  // namespace kerf::program
