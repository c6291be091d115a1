// The report as JSON for other programs. docs/json.md describes each key.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

inline constexpr int kJsonSchemaVersion = 1;

// One object on one line, with its end.
[[nodiscard]] std::string json_report(const FileReport& report);

}  // namespace kerf::program
