// One place of a path: how it bends there, and the feedrate allowed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "curves/position.hpp"
#include "lookahead/path/limits.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::lookahead {

struct PathSample : curves::PathDerivatives {
  double s_mm = 0.0;
  // Of the axes' jerk in mm/s^3 over the feedrate squared: what a third difference of positions
  // sees of jumps of curvature within its reach.
  curves::Position jumps_per_mm_s{};
  double feedrate_mm_s = kUnbounded;
  Constraint limit = Constraint::programmed;  // that feedrate_mm_s comes from

  // A lower feedrate stands in its place.
  void bind_feedrate(double bound_mm_s, Constraint from) noexcept {
    if (bound_mm_s < feedrate_mm_s) {
      feedrate_mm_s = bound_mm_s;
      limit = from;
    }
  }
};

// What an axis sees of the motion along the path, term by term.
struct AxisTerms {
  double tangential_mm_s2 = 0.0;   // q' a
  double centripetal_mm_s2 = 0.0;  // q'' v^2
  double along_mm_s3 = 0.0;        // q' j
  double cross_mm_s3 = 0.0;        // 3 q'' v a
  double third_mm_s3 = 0.0;        // q''' v^3

  [[nodiscard]] double acceleration_mm_s2() const noexcept {
    return tangential_mm_s2 + centripetal_mm_s2;
  }
  [[nodiscard]] double jerk_mm_s3() const noexcept {
    return along_mm_s3 + cross_mm_s3 + third_mm_s3;
  }
};

inline AxisTerms axis_terms(const curves::PathDerivatives& path, std::size_t axis,
                            const profiles::PathMotion& motion) noexcept {
  const double v = motion.v_mm_s;
  const double q2 = path.second_per_mm[axis];
  return {.tangential_mm_s2 = path.first[axis] * motion.a_mm_s2,
          .centripetal_mm_s2 = q2 * v * v,
          .along_mm_s3 = path.first[axis] * motion.j_mm_s3,
          .cross_mm_s3 = 3.0 * q2 * v * motion.a_mm_s2,
          .third_mm_s3 = path.third_per_mm2[axis] * v * v * v};
}

// The weakest axis in the direction of the path, or what is given where that is weaker.
inline double weakest_along(double given, const curves::PathDerivatives& path,
                            const PlanLimits& limits, double MotionLimits::*limit) {
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    if (path.first[k] != 0.0) {
      given = std::min(given, limits.axes[k].*limit / std::abs(path.first[k]));
    }
  }
  return given;
}

}  // namespace kerf::lookahead
