// A block and what is in force before it, as JSON: docs/json.md.
#pragma once

#include <nlohmann/json.hpp>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// extra: the machine's axes beside X, Y and Z.
[[nodiscard]] nlohmann::ordered_json block_json(const BlockReport& report, parser::Letters extra);

[[nodiscard]] nlohmann::ordered_json start_json(const StartReport& report, parser::Letters extra);

}  // namespace kerf::program
