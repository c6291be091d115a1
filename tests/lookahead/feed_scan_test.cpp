// The chord-error scan against the closed form of a circle, and against ticks of planned motion at
// many phases.
#include "lookahead/path/feed_scan.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"
#include "tests/lookahead/chords.hpp"
#include "tests/lookahead/motion.hpp"

namespace kerf::lookahead::test {
namespace {

using curves::testing::shipped_curve;
using curves::testing::shipped_curves;
using profiles::Profile;
using profiles::ProfileKind;

TEST(FeedScan, OfACircleIsTheClosedForm) {
  for (const double radius : {0.01, 0.5, 20.0, 400.0}) {
    SCOPED_TRACE(radius);
    const double d = 5e-4;
    const double expected = 2.0 / 0.001 * std::sqrt(2.0 * radius * d - d * d);
    const VelocityLimitCurve limit_curve = scan_feedrate(
        smooth_curve(nurbs_circle(radius)), {.period_s = 0.001, .chord_tolerance_mm = d});
    ASSERT_GE(limit_curve.size(), 3U);
    for (const FeedSample& sample : limit_curve) {
      EXPECT_LE(sample.v_mm_s, expected * (1.0 + 1e-9));
      EXPECT_GE(sample.v_mm_s, expected * 0.999);
    }
  }
}

TEST(FeedScan, TakesTheProgrammedFeedrateWhereTheChordAllowsMore) {
  const VelocityLimitCurve limit_curve = scan_feedrate(
      smooth_curve(nurbs_circle(20.0)),
      {.feedrate_mm_s = 50.0, .along = {.jerk_mm_s3 = 55'000.0}, .chord_tolerance_mm = 5e-4});
  for (const FeedSample& sample : limit_curve) {
    EXPECT_EQ(sample.v_mm_s, 50.0);
  }
}

TEST(FeedScan, CoversTheCurveFromEndToEndInOrder) {
  for (const auto& named : shipped_curves()) {
    SCOPED_TRACE(named.name);
    for (const auto& part : smooth_parts(named.data)) {
      const VelocityLimitCurve limit_curve =
          scan_feedrate(part, {.feedrate_mm_s = 100.0, .chord_tolerance_mm = 5e-4});
      EXPECT_EQ(limit_curve.front().s_mm, 0.0);
      EXPECT_EQ(limit_curve.back().s_mm, part.length_mm());
      for (std::size_t i = 1; i < limit_curve.size(); ++i) {
        ASSERT_GT(limit_curve[i].s_mm, limit_curve[i - 1].s_mm);
        ASSERT_GE(limit_curve[i].u, limit_curve[i - 1].u);
        ASSERT_GT(limit_curve[i].v_mm_s, 0.0);
        ASSERT_LE(limit_curve[i].v_mm_s, 100.0);
      }
    }
  }
}

TEST(FeedScan, StepsNoFartherThanATick) {
  for (const auto& named : shipped_curves()) {
    SCOPED_TRACE(named.name);
    for (const auto& part : smooth_parts(named.data)) {
      const VelocityLimitCurve limit_curve =
          scan_feedrate(part, {.feedrate_mm_s = 100.0, .chord_tolerance_mm = 5e-4});
      for (std::size_t i = 1; i < limit_curve.size(); ++i) {
        EXPECT_LE(limit_curve[i].s_mm - limit_curve[i - 1].s_mm, 0.1);
      }
    }
  }
}

TEST(FeedScan, InQuartersOfPiecesSeesAStraightPartAtFewPlaces) {
  const auto curve = smooth_curve(curves::testing::shipped_curve("mazatrol"));
  ScanLimits limits{.feedrate_mm_s = 20.0, .chord_tolerance_mm = 5e-4};
  const std::size_t fine = scan_feedrate(curve, limits).size();
  limits.plan = ScanFor::time_optimum;
  const std::size_t coarse = scan_feedrate(curve, limits).size();
  EXPECT_LT(coarse, fine / 4);
  EXPECT_GE(coarse, 4 * curve.pieces().size());
}

// Between samples the limit curve is a straight line, which may pass over what the curve allows
// there: by 2e-4 of the tolerance on the butterfly.
class ScannedIn : public testing::TestWithParam<ScanFor> {};

TEST_P(ScannedIn, KeepsTheChordToleranceOfPlannedTicksAtEveryPhaseToAThousandth) {
  const PlanLimits limits = butterfly_limits();
  for (const auto& named : shipped_curves()) {
    SCOPED_TRACE(named.name);
    for (const auto& part : smooth_parts(named.data)) {
      Block block = blocks_of({nurbs_move(named.data)}, limits).front();
      block.curve = part;
      block.length_mm = part.length_mm();
      block.limit_curve = scan_feedrate(part, {.feedrate_mm_s = 100.0,
                                               .along = {.jerk_mm_s3 = 55'000.0},
                                               .chord_tolerance_mm = limits.chord_tolerance_mm,
                                               .plan = GetParam()});
      const Motion motion = plan({block}, {.limits = limits});
      double largest = 0.0;
      for (int phase = 0; phase < 7; ++phase) {
        double before = motion.at(0.0).s_mm;
        for (double t = phase * 0.001 / 7.0; t < motion.duration_s() + 0.001; t += 0.001) {
          const double s = motion.at(t).s_mm;
          largest = std::max(largest, chord_error_mm(part, before, s));
          before = s;
        }
      }
      EXPECT_LE(largest, 1.001 * limits.chord_tolerance_mm);
      EXPECT_GT(largest, 0.0);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(FeedScan, ScannedIn,
                         testing::Values(ScanFor::bounded_jerk, ScanFor::time_optimum));

// A quadratic whose curvature falls to a tenth and rises again at its inner knots.
curves::NurbsData curvature_jumps() {
  curves::NurbsData data{.degree = 2, .points = {}, .knots = {0, 0, 0, 1, 2, 3, 3, 3}};
  for (const Position& point :
       {Position{0, 0, 0}, {4, 3, 0}, {9, 3.2, 0}, {14, 3.2, 0}, {18, 0, 0}}) {
    data.points.push_back({.position_mm = point});
  }
  return data;
}

// Its radius at the apex is a thousandth of a nanometre.
curves::NurbsData sharp_turn() {
  return {.degree = 2,
          .points = {{{0, 0, 0}}, {{10, 1e-4, 0}}, {{0, 2e-4, 0}}},
          .knots = {0, 0, 0, 1, 1, 1}};
}

// Any tick that is run at the limit curve of its middle, wherever it falls between samples.
TEST(FeedScan, KeepsTheChordToleranceBetweenItsSamplesToAThousandth) {
  const double ts = 0.001;
  std::vector<curves::testing::NamedCurve> curves = shipped_curves();
  curves.push_back({"curvature jumps", curvature_jumps()});
  curves.push_back({"sharp turn", sharp_turn()});
  for (const auto& named : curves) {
    SCOPED_TRACE(named.name);
    for (const auto& part : smooth_parts(named.data)) {
      for (const double d : {2e-5, 5e-4}) {
        const VelocityLimitCurve limit_curve =
            scan_feedrate(part, {.feedrate_mm_s = 100.0, .period_s = ts, .chord_tolerance_mm = d});
        double largest = 0.0;
        for (double s = 0.0; s < part.length_mm();) {
          const double half_mm = 0.5 * ts * feedrate_at_mm_s(limit_curve, s);
          if (s >= half_mm && s + half_mm <= part.length_mm()) {
            largest = std::max(largest, chord_error_mm(part, s - half_mm, s + half_mm));
          }
          s += 0.13 * half_mm;
        }
        EXPECT_LE(largest, 1.001 * d);
        EXPECT_GT(largest, 0.0);
      }
    }
  }
}

// A tick may begin fast just before the apex, one that begins at it may not: what bounds the latter
// stands at the apex, and not where the former has its middle.
TEST(FeedScan, BoundsASharpTurnAtItsApexAlone) {
  const curves::NurbsCurve curve = smooth_curve(sharp_turn());
  const VelocityLimitCurve limit_curve =
      scan_feedrate(curve, {.feedrate_mm_s = 100.0, .period_s = 0.001, .chord_tolerance_mm = 5e-4});
  const double apex = 0.5 * curve.length_mm();
  double slowest = 100.0;
  for (const FeedSample& sample : limit_curve) {
    if (std::abs(sample.s_mm - apex) < 1e-3) {
      slowest = std::min(slowest, sample.v_mm_s);
    } else if (sample.s_mm > apex + 2e-3) {
      // As fast as lets the tick around it begin after the apex.
      const double behind = 2.0 * (sample.s_mm - apex) / 0.001;
      EXPECT_GT(sample.v_mm_s, std::min(0.9 * behind, 95.0)) << sample.s_mm - apex;
    }
  }
  EXPECT_LT(slowest, 2.0 * 5e-4 / 0.001);  // there and back, by the tolerance each
}

// No point of a way is farther than half of it from the nearer one of its ends: not even twice as
// far is there a chord error.
TEST(FeedScan, LetsATickGoAsFarAsTheToleranceHoweverTheCurveTurns) {
  const double d = 5e-4;
  std::vector<curves::NurbsData> curves{sharp_turn()};
  for (const double size_mm : {1e-9, 1e-6, 1e-3, 1.0}) {
    for (const double light : {1.0, 1e-2, 1e-4}) {
      curves.push_back(
          {.degree = 2,
           .points = {{{0, 0, 0}, 0.1}, {{size_mm, 0, 0}, light}, {{size_mm, size_mm, 0}, 1.0}},
           .knots = {0, 0, 0, 1, 1, 1}});
    }
  }
  for (const curves::NurbsData& data : curves) {
    for (const ScanFor plan : {ScanFor::bounded_jerk, ScanFor::time_optimum}) {
      for (const FeedSample& sample : scan_feedrate(
               smooth_curve(data), {.period_s = 0.001, .chord_tolerance_mm = d, .plan = plan})) {
        EXPECT_GE(sample.v_mm_s, 0.999 * d / 0.001) << data.points[1].position_mm[0];
      }
    }
  }
}

// Where a curve runs along X at the feedrate v and with the curvature k, X sees the jerk j - k^2
// v^3: around the lowest feedrate j may be that much higher than the limit of X, and the mean
// feedrate of the tick is j Ts^2 / 24 above the lowest.
TEST(FeedScan, LeavesRoomForTheJerkThatCurvatureTakesOffAnAxis) {
  const double ts = 0.001;
  const double d = 5e-5;
  const curves::NurbsCurve curve =
      smooth_curve({.degree = 2,
                    .points = {{{-0.039, 0.034, 0.0}}, {{0.0, -0.034, 0.0}}, {{0.039, 0.034, 0.0}}},
                    .knots = {0, 0, 0, 1, 1, 1}});
  const double apex_mm = 0.5 * curve.length_mm();
  const double curvature = curves::vec(curve.derivatives_at(apex_mm).second_per_mm).norm();
  for (const double limit : {1e3, 1.6e4, 1e5}) {
    const VelocityLimitCurve limit_curve = scan_feedrate(
        curve, {.feedrate_mm_s = 100.0,
                .axes = {MotionLimits{.jerk_mm_s3 = limit}, MotionLimits{.jerk_mm_s3 = 1e6}},
                .period_s = ts,
                .chord_tolerance_mm = d});
    const double lowest = feedrate_at_mm_s(limit_curve, apex_mm);
    const double jerk = limit + curvature * curvature * lowest * lowest * lowest;
    const double half_mm = 0.5 * ts * (lowest + jerk * ts * ts / 24.0);
    EXPECT_LE(chord_error_mm(curve, apex_mm - half_mm, apex_mm + half_mm), d) << limit;
    EXPECT_GE(chord_error_mm(curve, apex_mm - half_mm, apex_mm + half_mm), 0.99 * d) << limit;
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
