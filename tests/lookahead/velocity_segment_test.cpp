// One segment: closed forms of the S-curve and the trapezoid, the four situations, the limit curve
// between samples, parts at constant velocity, braking.
#include "lookahead/classical/velocity_segment.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "lookahead/classical/split.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(VelocitySegment, FromRestToRestIsTheSCurvesClosedForm) {
  const Profile profile{ProfileKind::s_curve};
  // Long: both limits and the feedrate are reached. T = 2 (V/A + A/J) + (L - V (V/A + A/J)) / V.
  const double v = 200.0;
  const double up = v / kA + kA / kJ;
  const SegmentPlan plan = plan_segment(flat_segment(100.0, v), {}, profile);
  EXPECT_NEAR(plan.duration_s(), 2.0 * up + (100.0 - v * up) / v, 1e-12);
  // Short: the jerk alone binds, four phases of T/4: L = J T^3 / 32.
  const double length = 0.5;
  EXPECT_NEAR(plan_segment(flat_segment(length, v), {}, profile).duration_s(),
              std::cbrt(32.0 * length / kJ), 1e-9);
}

TEST(VelocitySegment, FromRestToRestIsTheTrapezoidsClosedForm) {
  const Profile profile{ProfileKind::trapezoid};
  EXPECT_NEAR(plan_segment(flat_segment(100.0, 200.0), {}, profile).duration_s(),
              200.0 / kA + 100.0 / 200.0, 1e-12);
  EXPECT_NEAR(plan_segment(flat_segment(2.0, 200.0), {}, profile).duration_s(),
              2.0 * std::sqrt(2.0 / kA), 1e-12);
}

TEST(VelocitySegment, OfASituationHasItsParts) {
  const Profile profile{ProfileKind::s_curve};
  struct Case {
    const char* name;
    double length_mm;
    SegmentEnds ends;
    bool acceleration, cruise, deceleration;
  };
  const std::vector<Case> cases{{"ACC + CF", 50.0, {0.0, 100.0}, true, true, false},
                                {"CF + DEC", 50.0, {100.0, 20.0}, false, true, true},
                                {"ACC + DEC", 2.0, {20.0, 10.0}, true, false, true},
                                {"ACC + CF + DEC", 50.0, {20.0, 10.0}, true, true, true},
                                {"ACC", 0.0, {20.0, 70.0}, true, false, false},
                                {"DEC", 0.0, {70.0, 20.0}, false, false, true},
                                {"CF", 50.0, {100.0, 100.0}, false, true, false}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    // Of one transition alone, just its length.
    const double length_mm = c.length_mm > 0.0 ? c.length_mm : 0.5 * 90.0 * s_curve_s(50.0);
    const VelocitySegment segment = flat_segment(length_mm * (1.0 + 1e-14), 100.0);
    const SegmentPlan plan = plan_segment(segment, c.ends, profile);
    expect_joined(segment, c.ends, plan);
    EXPECT_EQ(kind_of(plan), c.name);
    EXPECT_EQ(plan.acceleration.duration_s() > 0.0, c.acceleration);
    EXPECT_EQ(plan.cruise.duration_s() > 1e-6, c.cruise);
    EXPECT_EQ(plan.deceleration.duration_s() > 0.0, c.deceleration);
  }
}

TEST(VelocitySegment, WithoutACruiseTakesItsWholeLengthForTheTwoTransitions) {
  const Profile profile{ProfileKind::s_curve};
  const SegmentEnds ends{.v_begin_mm_s = 20.0, .v_end_mm_s = 10.0};
  const SegmentPlan plan = plan_segment(flat_segment(2.0, 100.0), ends, profile);
  const double peak = plan.acceleration.ramp().v_end_mm_s;
  EXPECT_NEAR(
      0.5 * (20.0 + peak) * s_curve_s(peak - 20.0) + 0.5 * (10.0 + peak) * s_curve_s(peak - 10.0),
      2.0, 1e-9);
}

TEST(VelocitySegment, OfAnyLengthJoinsItsEndsUnderEveryLaw) {
  const unsigned seed = 20'261'121;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const Profile profile{all_kinds()[static_cast<std::size_t>(i) % all_kinds().size()]};
    const double cap = 200.0 * share(random);
    VelocitySegment segment = flat_segment(std::pow(10.0, -6.0 + 9.0 * share(random)), cap);
    SegmentEnds ends{.v_begin_mm_s = 0.0, .v_end_mm_s = cap * share(random)};
    ends.v_begin_mm_s = reach_backward_mm_s(
        segment, {.v_end_mm_s = ends.v_end_mm_s, .cap_mm_s = cap * share(random)}, profile);
    ends.v_end_mm_s = end_feedrate_mm_s(segment, ends, ends.v_end_mm_s, profile);
    const SegmentPlan plan = plan_segment(segment, ends, profile);
    expect_joined(segment, ends, plan);
    for (const auto part : parts()) {
      EXPECT_LE((plan.*part).ramp().v_end_mm_s, cap * (1.0 + 1e-12));
    }
    if (testing::Test::HasFailure()) {
      FAIL() << "case " << i << ", length " << segment.length_mm;
    }
  }
}

TEST(VelocitySegment, ReachesBackwardWhatItReachesForward) {
  for (const ProfileKind kind : all_kinds()) {
    SCOPED_TRACE(profiles::name_of(kind));
    const Profile profile{kind};
    for (const double length : {1e-5, 0.01, 0.4, 3.0}) {
      for (const double v : {0.0, 0.5, 30.0}) {
        const VelocitySegment segment = flat_segment(length, 1e4);
        const double up =
            end_feedrate_mm_s(segment, {.v_begin_mm_s = v, .v_end_mm_s = 1e4}, 1e4, profile);
        const double down =
            reach_backward_mm_s(segment, {.v_end_mm_s = v, .cap_mm_s = 1e4}, profile);
        EXPECT_GT(up, v);
        EXPECT_NEAR(up, down, 1e-9 * up);
        // From what was reached upwards the segment is braked to where it began.
        EXPECT_NEAR(0.5 * (v + up) * profile.duration_s(up - v, segment.limits.ramp), length,
                    1e-9 * length + 1e-10);
      }
    }
  }
}

// Braking from v to v / 3 under a jerk takes more room than braking to rest: the length is
// (v + w) sqrt((v - w) / J), largest at w = v / 3. So when a window grows and the end need not be
// at rest any more, a faster end may not fit although it is less of a change.
TEST(VelocitySegment, EndsWithWhatFitsWhereARestFitsAndAFasterEndDoesNot) {
  const Profile profile{ProfileKind::s_curve};
  const double v = 10.0;
  const VelocitySegment segment =
      flat_segment(v * std::sqrt(v / kJ), 100.0);  // room for a rest, exactly
  const SegmentEnds wanted{.v_begin_mm_s = v, .v_end_mm_s = v / 3.0};
  ASSERT_GT((v + v / 3.0) * std::sqrt(v * 2.0 / 3.0 / kJ), segment.length_mm);
  SegmentEnds ends = wanted;
  ends.v_end_mm_s = end_feedrate_mm_s(segment, wanted, 0.0, profile);
  expect_joined(segment, ends, plan_segment(segment, ends, profile));
}

TEST(VelocitySegment, KeepsConstantVelocityAtBothEnds) {
  const Profile profile{ProfileKind::s_curve};
  VelocitySegment segment = flat_segment(5.0, 100.0);
  segment.begin_constant_velocity_s = 0.003;
  segment.end = {.feedrate_mm_s = 20.0, .constant_velocity_s = 0.003};
  const SegmentEnds ends{.v_begin_mm_s = 30.0, .v_end_mm_s = 20.0};
  const SegmentPlan plan = plan_segment(segment, ends, profile);
  expect_joined(segment, ends, plan);
  EXPECT_NEAR(plan.begin_constant_velocity.duration_s(), 0.003, 1e-15);
  EXPECT_NEAR(plan.end_constant_velocity.duration_s(), 0.003, 1e-15);
  EXPECT_EQ(plan.end_constant_velocity.ramp().v_begin_mm_s, 20.0);
}

TEST(VelocitySegment, WithConstantVelocityReachesFromWhereItsPlanFits) {
  const Profile profile{ProfileKind::s_curve};
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    VelocitySegment segment = flat_segment(std::pow(10.0, -4.0 + 5.0 * share(random)), 200.0);
    segment.begin_constant_velocity_s = 0.003;
    segment.end.constant_velocity_s = 0.003;
    const double fits = segment.length_mm / 0.006;  // as a junction promises
    const double v_end = std::min(fits, 200.0) * share(random);
    const double cap = std::min(fits, 200.0) * share(random);
    SegmentEnds ends{.v_begin_mm_s = 0.0, .v_end_mm_s = v_end};
    ends.v_begin_mm_s =
        reach_backward_mm_s(segment, {.v_end_mm_s = v_end, .cap_mm_s = cap}, profile);
    ASSERT_LE(ends.v_begin_mm_s, cap);
    ends.v_end_mm_s = end_feedrate_mm_s(segment, ends, ends.v_end_mm_s, profile);
    ASSERT_LE(ends.v_end_mm_s, v_end);
    expect_joined(segment, ends, plan_segment(segment, ends, profile));
    ASSERT_FALSE(testing::Test::HasFailure()) << "case " << i;
  }
}

// Limit curves as scans give them: the butterfly's and the scroll's, cut at their valleys.
TEST(VelocitySegment, IsNeverAboveTheLimitCurveOfACurve) {
  for (const char* name : {"butterfly", "star", "trident7"}) {
    SCOPED_TRACE(name);
    const Block block =
        blocks_of({nurbs_move(curves::testing::shipped_curve(name))}, butterfly_limits()).front();
    for (const ProfileKind kind : all_kinds()) {
      SCOPED_TRACE(profiles::name_of(kind));
      const Profile profile{kind};
      double v_begin = 0.0;
      double s_begin = 0.0;
      for (const VelocitySegment& segment : split(block, 0.001)) {
        EXPECT_NEAR(segment.s_begin_mm, s_begin, 1e-12);
        SegmentEnds ends{.v_begin_mm_s = v_begin, .v_end_mm_s = segment.end.feedrate_mm_s};
        const double cap = limit_curve_at(block.limit_curve, s_begin);
        ends.v_begin_mm_s = std::min(
            v_begin, reach_backward_mm_s(segment, {.v_end_mm_s = ends.v_end_mm_s, .cap_mm_s = cap},
                                         profile));
        ends.v_end_mm_s = end_feedrate_mm_s(segment, ends, ends.v_end_mm_s, profile);
        const SegmentPlan plan = plan_segment(segment, ends, profile);
        expect_joined(segment, ends, plan);
        const Excess excess = excess_of(
            plan, [&](double s) { return limit_curve_at(block.limit_curve, s_begin + s); });
        EXPECT_LE(excess.share, 1e-3) << "segment at " << s_begin;
        v_begin = ends.v_end_mm_s;
        s_begin += segment.length_mm;
      }
      EXPECT_NEAR(s_begin, block.length_mm, 1e-9);
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
