// The report as other programs read it. docs/json.md says what every key means.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

inline constexpr int kJsonSchemaVersion = 1;

// One object on one line, with its end.
[[nodiscard]] std::string json_report(const FileReport& report);

}  // namespace kerf::program
