// The S-curve from any motion to rest.
#pragma once

#include <optional>

#include "profiles/cell_law.hpp"
#include "profiles/transition.hpp"

namespace kerf::profiles {

// Jerk down to the lowest acceleration, that acceleration, jerk up to rest. Parts may be empty.
struct SCurveStop {
  CellLaw falling{};
  CellLaw steady{};
  CellLaw landing{};

  [[nodiscard]] double length_mm() const noexcept {
    return falling.length_mm() + steady.length_mm() + landing.length_mm();
  }
};

// The shortest, from a feedrate above 0 and an acceleration of either sign. Nothing: a limit is
// infinite, the acceleration is over its limit, or the motion decelerates so much that a jerk
// within its limit cannot end it at rest.
std::optional<SCurveStop> s_curve_stop(const PathMotion& from, const RampLimits& limits) noexcept;

}  // namespace kerf::profiles
