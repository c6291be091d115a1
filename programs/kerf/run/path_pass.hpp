// A look at the path that is planned, before the run: for the page.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"

namespace kerf::program {

struct PathPassOrder {
  const MachineSettings& settings;
  const KernelOptions& kernel_options;
  bool leaves_travel = false;  // and is followed where it does
};

// Of the rewound file, which has passed its check but for the travel: PageRecord::planned and
// ::files, of what can be read of it.
void path_pass(ProgramFile& file, const PathPassOrder& order, PageRecord& page);

}  // namespace kerf::program
