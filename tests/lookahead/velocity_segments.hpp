// Segments, their closed forms and what holds for every plan of one, for the tests of the
// look-ahead.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "lookahead/classical/velocity_segment.hpp"

namespace kerf::lookahead::test {

using profiles::Profile;
using profiles::ProfileKind;
using profiles::Transition;

inline constexpr double kA = 3000.0;
inline constexpr double kJ = 55'000.0;

inline const std::vector<ProfileKind>& all_kinds() {
  static const std::vector<ProfileKind> kinds{ProfileKind::trapezoid,   ProfileKind::s_curve,
                                              ProfileKind::sine,        ProfileKind::quintic,
                                              ProfileKind::sine_series, ProfileKind::sigmoid};
  return kinds;
}

inline std::vector<ProfileKind> jerk_limited_kinds() {
  return {std::next(all_kinds().begin()), all_kinds().end()};
}

inline VelocitySegment flat_segment(double length_mm, double feedrate_mm_s) {
  return {.length_mm = length_mm,
          .limits = {.feedrate_mm_s = feedrate_mm_s,
                     .ramp = {.acceleration_mm_s2 = kA, .jerk_mm_s3 = kJ}}};
}

// The S-curve's duration, docs/math.md, 2.3.
inline double s_curve_s(double change) {
  return change >= kA * kA / kJ ? change / kA + kA / kJ : 2.0 * std::sqrt(change / kJ);
}

inline double length_of(const SegmentPlan& plan) {
  return plan.begin_constant_velocity.length_mm() + plan.acceleration.length_mm() +
         plan.cruise.length_mm() + plan.deceleration.length_mm() +
         plan.end_constant_velocity.length_mm();
}

inline const std::vector<const Transition SegmentPlan::*>& parts() {
  static const std::vector<const Transition SegmentPlan::*> all{
      &SegmentPlan::begin_constant_velocity, &SegmentPlan::acceleration, &SegmentPlan::cruise,
      &SegmentPlan::deceleration, &SegmentPlan::end_constant_velocity};
  return all;
}

// Feedrates join, begin and end where asked for, and the lengths add up to the segment's.
inline void expect_joined(const VelocitySegment& segment, const SegmentEnds& ends,
                          const SegmentPlan& plan) {
  EXPECT_NEAR(length_of(plan), segment.length_mm, 1e-9 * segment.length_mm + 1e-12);
  double v = ends.v_begin_mm_s;
  for (const auto part : parts()) {
    const Transition& law = plan.*part;
    if (law.duration_s() > 0.0) {
      EXPECT_NEAR(law.ramp().v_begin_mm_s, v, 1e-9 * (1.0 + v));
      v = law.ramp().v_end_mm_s;
    }
  }
  EXPECT_NEAR(v, ends.v_end_mm_s, 1e-9 * (1.0 + v));
}

struct Excess {
  double feedrate_mm_s = 0.0;
  double share = 0.0;  // of what is allowed
};

// The largest excess of the plan over a piecewise linear limit curve, at 2000 points of each part.
template <class Allowed>
inline Excess excess_of(const SegmentPlan& plan, const Allowed& allowed_mm_s) {
  Excess worst;
  double s = 0.0;
  for (const auto part : parts()) {
    const Transition& law = plan.*part;
    for (int i = 0; i <= 2000 && law.duration_s() > 0.0; ++i) {
      const auto point = law.at(law.duration_s() * i / 2000.0);
      const double allowed = allowed_mm_s(s + point.s_mm);
      worst.feedrate_mm_s = std::max(worst.feedrate_mm_s, point.v_mm_s - allowed);
      worst.share = std::max(worst.share, point.v_mm_s / allowed - 1.0);
    }
    s += law.length_mm();
  }
  return worst;
}

inline double limit_curve_at(const VelocityLimitCurve& limit_curve, double s_mm) {
  const auto after =
      std::upper_bound(limit_curve.begin(), limit_curve.end(), s_mm,
                       [](double s, const FeedSample& sample) { return s < sample.s_mm; });
  if (after == limit_curve.begin() || after == limit_curve.end()) {
    return after == limit_curve.end() ? limit_curve.back().v_mm_s : limit_curve.front().v_mm_s;
  }
  const FeedSample& high = *after;
  const FeedSample& low = *std::prev(after);
  return low.v_mm_s + (high.v_mm_s - low.v_mm_s) * (s_mm - low.s_mm) / (high.s_mm - low.s_mm);
}

}  // namespace kerf::lookahead::test
