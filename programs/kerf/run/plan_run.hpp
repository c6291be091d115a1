// The plan of one program, from its text to its report.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/motion_run.hpp"

namespace kerf::program {

struct PlanRunOrder {
  const Options& options;
  const MachineSettings& settings;
  const KernelOptions& kernel_options;
  const CheckedPath& path;
  bool shows_progress = false;
};

// Plans the rewound file to its end, without ticks. Fills in what was found, why it is over, and
// for `kerf explain` the block that was asked for.
void run_plan(const PlanRunOrder& order, ProgramFile& file, FileReport& report);

}  // namespace kerf::program
