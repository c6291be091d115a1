// The limits that a plan keeps. An infinite limit does not bind.
#pragma once

#include <kerf/axes.hpp>

#include "curves/auxiliary_axis_motion.hpp"
#include "interp/constraint.hpp"

namespace kerf::lookahead {

using kerf::kUnbounded;
using kerf::MotionLimits;
using PlanLimits = MachineLimits;
using interp::Constraint;

// The constraint that each limit along the path comes from.
struct LimitOrigins {
  Constraint feedrate = Constraint::programmed;
  Constraint acceleration = Constraint::path_acceleration;
  Constraint jerk = Constraint::path_jerk;
};

// The first of "velocity", "acceleration" and "jerk" that is bounded neither along the path nor on
// all axes, so that a rapid would have no end. Null: all are bounded.
const char* unbounded(const PlanLimits& limits);

}  // namespace kerf::lookahead
