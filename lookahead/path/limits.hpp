// The limits that a plan keeps. Infinity: does not bind.
#pragma once

#include <kerf/axes.hpp>

#include "curves/auxiliary_axis_motion.hpp"
#include "interp/constraint.hpp"

namespace kerf::lookahead {

using kerf::kUnbounded;
using kerf::MotionLimits;
using PlanLimits = MachineLimits;
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
