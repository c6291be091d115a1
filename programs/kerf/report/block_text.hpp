// What `kerf explain` prints.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Of a report without a block: nothing.
std::string block_text(const FileReport& report);

}  // namespace kerf::program
