// Where a program's path lies, as JSON: docs/json.md.
#pragma once

#include <nlohmann/json.hpp>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

[[nodiscard]] nlohmann::ordered_json boxes_json(const PathBoxes& boxes);

[[nodiscard]] nlohmann::ordered_json fit_json(const FitReport& fit);

}  // namespace kerf::program
