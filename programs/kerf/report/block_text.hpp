// The texts about a block and what is in force before it.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// What `kerf explain` prints. Empty for a report without a block.
std::string block_text(const FileReport& report);

// What somebody confirms before a program starts there, without the end of its last line.
// Precondition: FileReport::start.
std::string start_text(const FileReport& report);

}  // namespace kerf::program
