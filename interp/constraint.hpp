// The constraint that limits the feedrate at a tick.
#pragma once

#include <cstddef>

#include <kerf/setpoint.hpp>

namespace kerf::interp {

using kerf::Constraint;

inline constexpr std::size_t kConstraints = 35;
inline constexpr std::size_t kLimitedAxes = 9;

// first: x_velocity, x_acceleration or x_jerk. axis < kLimitedAxes.
constexpr Constraint of_axis(Constraint first, std::size_t axis) noexcept {
  return static_cast<Constraint>(static_cast<std::size_t>(first) + axis);
}
static_assert(static_cast<std::size_t>(of_axis(Constraint::x_jerk, kLimitedAxes)) == kConstraints);

// The constraint that limits the feedrate in a phase, and the one while the jerk is 0: in an
// S-curve they differ.
struct ActiveConstraint {
  Constraint limit = Constraint::rest;
  Constraint steady = Constraint::rest;
};

constexpr ActiveConstraint active_constraint(Constraint limit) noexcept {
  return {.limit = limit, .steady = limit};
}

}  // namespace kerf::interp
