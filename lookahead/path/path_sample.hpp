// One place of a path: how it bends there, and the feedrate allowed; and the velocity limit curve.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "curves/position.hpp"
#include "interp/axis_terms.hpp"
#include "interp/constraint.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

struct PathSample : curves::PathDerivatives {
  double s_mm = 0.0;
  // Jerk of the axes in mm/s^3, divided by the feedrate squared, that a third difference of
  // positions sees of jumps of curvature within its reach.
  curves::Position jumps_per_mm_s{};
  double feedrate_mm_s = kUnbounded;
  Constraint limit = Constraint::programmed;  // the origin of feedrate_mm_s

  // Takes the bound if it is lower.
  void bind_feedrate(double bound_mm_s, Constraint from) noexcept {
    if (bound_mm_s < feedrate_mm_s) {
      feedrate_mm_s = bound_mm_s;
      limit = from;
    }
  }
};

using interp::axis_terms;
using interp::AxisTerms;

// The limit of the weakest axis in the direction of the path, or `given` if that is lower.
inline double weakest_along(double given, const curves::PathDerivatives& path,
                            const PlanLimits& limits, double MotionLimits::*limit) {
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    if (path.first[k] != 0.0) {
      given = std::min(given, limits.axes[k].*limit / std::abs(path.first[k]));
    }
  }
  return given;
}

struct FeedSample {
  double u = 0.0;
  double s_mm = 0.0;
  double v_mm_s = 0.0;
  interp::Constraint limit = interp::Constraint::chord_error;  // the origin of v_mm_s
};

// Piecewise linear between samples; s ascends.
using VelocityLimitCurve = std::vector<FeedSample>;

}  // namespace kerf::lookahead
