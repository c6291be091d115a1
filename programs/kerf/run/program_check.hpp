// The whole program is checked before anything moves.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/options.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/report/report.hpp"
#include "programs/kerf/run/motion_run.hpp"

namespace kerf::program {

struct ProgramCheck {
  const Options& options;
  const MachineSettings& settings;
  KernelOptions& kernel_options;  // how long the program takes is set
  CheckedPath& path;              // is set
  bool shows_progress = false;
  PageRecord* page = nullptr;  // gets extents, text and path as it wants; may be null
};

// What is found goes into the report. True: the program may run.
bool check_program(const ProgramCheck& how, ProgramFile& file, FileReport& report);

}  // namespace kerf::program
