// What limits the feedrate at a tick.
#pragma once

#include <cstddef>
#include <cstdint>

namespace kerf::interp {

// One byte that the planner sets where it knows it. Of an axis the values are those of X plus the
// axis' number in XYZABCUVW.
enum class Constraint : std::uint8_t {
  rest,           // a dwell, an event, a wait for text or people
  programmed,     // F
  path_velocity,  // along the path, of rapids too
  path_acceleration,
  path_jerk,
  chord_error,
  junction,             // direction or curvature jumps between two blocks
  window_end,           // the look-ahead sees no farther and brakes
  x_velocity = 8,       // to 16
  x_acceleration = 17,  // to 25
  x_jerk = 26,          // to 34
};

inline constexpr std::size_t kConstraints = 35;
inline constexpr std::size_t kLimitedAxes = 9;

// first: x_velocity, x_acceleration or x_jerk. axis < kLimitedAxes.
constexpr Constraint of_axis(Constraint first, std::size_t axis) noexcept {
  return static_cast<Constraint>(static_cast<std::size_t>(first) + axis);
}

// In a phase: what binds, and what does while its jerk is 0. Of an S-curve the two differ.
struct ActiveConstraint {
  Constraint limit = Constraint::rest;
  Constraint steady = Constraint::rest;
};

constexpr ActiveConstraint active_constraint(Constraint limit) noexcept {
  return {.limit = limit, .steady = limit};
}

}  // namespace kerf::interp
