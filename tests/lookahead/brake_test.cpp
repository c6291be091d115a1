// A segment that has to be left as slow as may be: a stop on request.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/classical/split.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(Brake, StopsInTheSegmentWhereItCan) {
  const Profile profile{ProfileKind::s_curve};
  VelocitySegment segment = flat_segment(50.0, 100.0);
  const double v = 100.0;
  EXPECT_EQ(brake(segment, {.v_begin_mm_s = v, .v_end_mm_s = 80.0}, profile), 0.0);
  EXPECT_NEAR(segment.length_mm, 0.5 * v * s_curve_s(v), 1e-9);
  EXPECT_FALSE(segment.ends_block);
  const SegmentPlan plan = plan_segment(segment, {.v_begin_mm_s = v, .v_end_mm_s = 0.0}, profile);
  EXPECT_NEAR(plan.duration_s(), s_curve_s(v), 1e-9);
  expect_joined(segment, {.v_begin_mm_s = v, .v_end_mm_s = 0.0}, plan);
}

TEST(Brake, EndsAsSlowAsAShortSegmentAllows) {
  const Profile profile{ProfileKind::s_curve};
  VelocitySegment segment = flat_segment(1.0, 100.0);
  const double end = brake(segment, {.v_begin_mm_s = 100.0, .v_end_mm_s = 100.0}, profile);
  EXPECT_GT(end, 0.0);
  EXPECT_EQ(segment.length_mm, 1.0);
  EXPECT_NEAR(0.5 * (100.0 + end) * s_curve_s(100.0 - end), 1.0, 1e-6);
}

TEST(Brake, KeepsTheConstantVelocityThatItBeginsWith) {
  const Profile profile{ProfileKind::s_curve};
  VelocitySegment segment = flat_segment(50.0, 100.0);
  segment.begin_constant_velocity_s = 0.003;
  EXPECT_EQ(brake(segment, {.v_begin_mm_s = 40.0, .v_end_mm_s = 40.0}, profile), 0.0);
  EXPECT_NEAR(segment.length_mm, 40.0 * 0.003 + 0.5 * 40.0 * s_curve_s(40.0), 1e-9);
}

// Where the plan to the segment's end keeps the limit curve, so does the fall to rest.
TEST(Brake, StaysBelowTheLimitCurveOfACurve) {
  const Block block =
      blocks_of({nurbs_move(curves::testing::shipped_curve("butterfly"))}, butterfly_limits())
          .front();
  for (const ProfileKind kind : jerk_limited_kinds()) {
    SCOPED_TRACE(profiles::name_of(kind));
    const Profile profile{kind};
    for (const VelocitySegment& whole : split(block, 0.001)) {
      const double cap = limit_curve_at(block.limit_curve, whole.s_begin_mm);
      VelocitySegment segment = whole;
      SegmentEnds ends{.v_begin_mm_s = 0.0, .v_end_mm_s = segment.end.feedrate_mm_s};
      ends.v_begin_mm_s =
          reach_backward_mm_s(segment, {.v_end_mm_s = ends.v_end_mm_s, .cap_mm_s = cap}, profile);
      ends.v_end_mm_s = end_feedrate_mm_s(segment, ends, ends.v_end_mm_s, profile);
      ends.v_end_mm_s = brake(segment, ends, profile);
      const SegmentPlan plan = plan_segment(segment, ends, profile);
      expect_joined(segment, ends, plan);
      const Excess excess = excess_of(
          plan, [&](double s) { return limit_curve_at(block.limit_curve, whole.s_begin_mm + s); });
      EXPECT_LE(excess.share, 1e-3) << "segment at " << whole.s_begin_mm;
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
