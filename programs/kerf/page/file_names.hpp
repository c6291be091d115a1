// A page is given away: what it says of files is their names, not where they lie on a computer.
#pragma once

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// The report with no folder in the names of files, also where a message has them.
FileReport with_file_names(FileReport report);

}  // namespace kerf::program
