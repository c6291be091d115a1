// Ticks at the velocity limit curve, and their chord errors.
#pragma once

#include <algorithm>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead::test {

// The largest distance of 40 points of the path between two ticks from their chord.
inline double chord_error_mm(const curves::NurbsCurve& curve, double s_from_mm, double s_to_mm) {
  const curves::Position a = curve.at(s_from_mm);
  const curves::Position b = curve.at(s_to_mm);
  const Eigen::Vector3d chord = curves::vec(b) - curves::vec(a);
  double largest = 0.0;
  for (int k = 1; k < 40; ++k) {
    const curves::Position p = curve.at(s_from_mm + (s_to_mm - s_from_mm) * k / 40.0);
    const Eigen::Vector3d offset = curves::vec(p) - curves::vec(a);
    const double along = chord.squaredNorm() > 0.0
                             ? std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0)
                             : 0.0;
    largest = std::max(largest, (offset - along * chord).norm());
  }
  return largest;
}

// Precondition: two samples at least.
inline double feedrate_at_mm_s(const VelocityLimitCurve& limit_curve, double s_mm) {
  const auto after =
      std::upper_bound(limit_curve.begin() + 1, limit_curve.end() - 1, s_mm,
                       [](double s, const FeedSample& sample) { return s < sample.s_mm; });
  const FeedSample& a = *(after - 1);
  const FeedSample& b = *after;
  return a.v_mm_s + (b.v_mm_s - a.v_mm_s) * (s_mm - a.s_mm) / (b.s_mm - a.s_mm);
}

}  // namespace kerf::lookahead::test
