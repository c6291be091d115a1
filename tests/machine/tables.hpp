// Tables that the tests of the simulated table share.
#pragma once

#include <limits>

#include "machine/simulated_table.hpp"

namespace kerf::machine::test {

inline constexpr double kTick = 0.001;

inline TableSettings table_of(const AxisDrive& drive) {
  TableSettings settings{.period_s = kTick};
  settings.axes.fill(drive);
  return settings;
}

// Linear loops that lag: no quantisation, friction or feed-forward, no saturation within reach.
inline TableSettings lagging() {
  return table_of({.travel = {.min_mm = -300.0, .max_mm = 300.0},
                   .drive_velocity_mm_s = 1e5,
                   .drive_acceleration_mm_s2 = 1e8,
                   .counts_per_rev = std::numeric_limits<double>::infinity(),
                   .position_gain_per_s = 150.0,
                   .velocity_gain_per_s = 1500.0,
                   .velocity_integral_per_s2 = 0.0,
                   .feed_forward = 0.0,
                   .coulomb_friction_mm_s2 = 0.0,
                   .viscous_friction_per_s = 0.0});
}

// A real table: friction, encoders, limits.
inline TableSettings real() {
  return table_of({.travel = {.min_mm = -300.0, .max_mm = 300.0},
                   .position_gain_per_s = 150.0,
                   .velocity_gain_per_s = 1500.0,
                   .velocity_integral_per_s2 = 20e3,
                   .feed_forward = 0.9,
                   .coulomb_friction_mm_s2 = 300.0,
                   .viscous_friction_per_s = 5.0});
}

inline Setpoint at(const Position& position_mm) {
  return {.position_mm = position_mm};
}

}  // namespace kerf::machine::test
