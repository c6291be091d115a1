// The text that `kerf explain` prints.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Empty for a report without a block.
std::string block_text(const FileReport& report);

}  // namespace kerf::program
