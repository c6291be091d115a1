// What limits the feedrate at a tick.
#pragma once

#include <kerf/setpoint.hpp>

namespace kerf::interp {

using kerf::Constraint;
using kerf::kConstraints;
using kerf::kLimitedAxes;
using kerf::of_axis;

// In a phase: what binds, and what does while its jerk is 0. Of an S-curve the two differ.
struct ActiveConstraint {
  Constraint limit = Constraint::rest;
  Constraint steady = Constraint::rest;
};

constexpr ActiveConstraint active_constraint(Constraint limit) noexcept {
  return {.limit = limit, .steady = limit};
}

}  // namespace kerf::interp
