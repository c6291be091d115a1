// One program from its file to its report.
#pragma once

#include <string>

#include <kerf/machine.hpp>

#include "programs/kerf/options.hpp"
#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Checks the whole program first; nothing moves unless it is without error and within the travel.
// Then plans it (check) or runs it (dry-run, run), with trace and plot as the options say. Errors
// and faults of the program go to standard error as they are found; all else is in the report.
// page: filled in for the page, where it is not null.
FileReport process_file(const std::string& path, const Options& options,
                        const MachineSettings& settings, PageRecord* page = nullptr);

}  // namespace kerf::program
