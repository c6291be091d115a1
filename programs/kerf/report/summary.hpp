// The report as a machinist reads it.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Some lines of text, each with its end. A program that did not get as far as a plan has none: its
// errors say what there is to say.
[[nodiscard]] std::string summary(const FileReport& report);

}  // namespace kerf::program
