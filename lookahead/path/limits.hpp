// The limits that a plan keeps. Infinity: does not bind.
#pragma once

#include <array>
#include <limits>

#include "curves/auxiliary_axis_motion.hpp"
#include "interp/constraint.hpp"

namespace kerf::lookahead {

inline constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// Of one axis, or along the path.
struct MotionLimits {
  double velocity_mm_s = kUnbounded;
  double acceleration_mm_s2 = kUnbounded;
  double jerk_mm_s3 = kUnbounded;
};

struct PlanLimits {
  double period_s = 0.001;
  MotionLimits path{};
  std::array<MotionLimits, 3> axes{};
  // A, B, C, with rad in place of mm, then U, V, W. They bind whatever the limits along the path,
  // which do not count where only these axes move.
  std::array<MotionLimits, curves::kAuxiliaryAxes> extra{};
  double chord_tolerance_mm = kUnbounded;
};

using interp::Constraint;

// Which limit of the machine or of the program a limit along the path comes from.
struct LimitOrigins {
  Constraint feedrate = Constraint::programmed;
  Constraint acceleration = Constraint::path_acceleration;
  Constraint jerk = Constraint::path_jerk;
};

// What of "velocity", "acceleration" or "jerk" is bounded neither along the path nor on all axes: a
// rapid would have no end. Null: nothing.
const char* unbounded(const PlanLimits& limits);

}  // namespace kerf::lookahead
