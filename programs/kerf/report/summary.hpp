// The report as text for a machinist.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Some lines of text, each with its newline. Empty for a program without a plan: its errors say
// enough.
[[nodiscard]] std::string summary(const FileReport& report);

}  // namespace kerf::program
