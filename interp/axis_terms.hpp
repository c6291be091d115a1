// Acceleration and jerk of an axis from the motion along the path (docs/math.md, 5.1).
#pragma once

#include <cstddef>

#include "curves/position.hpp"
#include "profiles/shape_value.hpp"

namespace kerf::interp {

// Term by term: acceleration is the sum of two, jerk of three.
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

}  // namespace kerf::interp
