// What limits the feedrate at a tick.
#pragma once

#include <kerf/setpoint.hpp>

namespace kerf::interp {

using kerf::Constraint;
using kerf::kConstraints;
using kerf::kLimitedAxes;
using kerf::of_axis;

// What limits the feedrate in a phase, and what does while the jerk is 0: in an S-curve they
// differ.
struct ActiveConstraint {
  Constraint limit = Constraint::rest;
  Constraint steady = Constraint::rest;
};

constexpr ActiveConstraint active_constraint(Constraint limit) noexcept {
  return {.limit = limit, .steady = limit};
}

}  // namespace kerf::interp
