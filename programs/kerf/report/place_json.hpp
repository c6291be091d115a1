// Where a program's path lies, as JSON: docs/json.md.
#pragma once

#include <array>

#include <nlohmann/json.hpp>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Of X, Y and Z.
[[nodiscard]] nlohmann::ordered_json axes_json(const std::array<double, 3>& values);

[[nodiscard]] nlohmann::ordered_json boxes_json(const PathBoxes& boxes);

[[nodiscard]] nlohmann::ordered_json fit_json(const FitReport& fit);

}  // namespace kerf::program
