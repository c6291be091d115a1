// The constraints of the feedrate as text: a part of the summary.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Lines of the summary; empty where --explain-speed was not asked for.
[[nodiscard]] std::string speed_text(const FileReport& report);

}  // namespace kerf::program
