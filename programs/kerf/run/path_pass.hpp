// A look at the path that is planned, without its plan: for the page.
#pragma once

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"

namespace kerf::program {

struct PathOrder {
  const MachineSettings& settings;
  const KernelOptions& options;
  double feed_override = 1.0;  // Options::feed_override
};

// Of the rewound file, which has passed its check but for the travel: PageRecord::planned, also
// where it leaves the travel, and nominal.
void path_pass(const PathOrder& order, ProgramFile& file, PageRecord& page);

}  // namespace kerf::program
