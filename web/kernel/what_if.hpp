// What a visitor of the page asks: the same program on another machine, or run otherwise.
#pragma once

#include <optional>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <nlohmann/json_fwd.hpp>

namespace kerf::browser {

struct WhatIf {
  double velocity = 1.0;  // of each limit of the machine that is bounded
  double acceleration = 1.0;
  double jerk = 1.0;
  Overrides overrides{};
  std::optional<double> corner_tolerance_mm;  // what G64 without P and Q takes for P
  std::optional<double> merge_tolerance_mm;   // and for Q; none: as P
};

// {"velocity": 1, "acceleration": 1.2, "jerk": 1, "feed": 0.8, "rapid": 1, "corner_tolerance_mm":
// 0.02, "merge_tolerance_mm": null}. Throws where it is something else.
WhatIf what_if_of(const nlohmann::json& question);

// The simulated table gets the drives that the limits need. The error: no machine can be so.
std::optional<SettingsError> change(MachineSettings& settings, const WhatIf& what_if);

}  // namespace kerf::browser
