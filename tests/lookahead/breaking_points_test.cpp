// Breaking points of limit curves made by hand, and the butterfly's that the paper counts.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "lookahead/classical/limit_curve_cuts.hpp"
#include "lookahead/path/feed_scan.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"

namespace kerf::lookahead::test {
namespace {

VelocityLimitCurve limit_curve_of(const std::vector<double>& v_mm_s) {
  VelocityLimitCurve limit_curve;
  for (std::size_t i = 0; i < v_mm_s.size(); ++i) {
    const auto x = static_cast<double>(i);
    limit_curve.push_back({.u = x, .s_mm = x, .v_mm_s = v_mm_s[i]});
  }
  return limit_curve;
}

using Indices = std::vector<std::size_t>;

TEST(BreakingPoints, OfAFlatLimitCurveAreItsEnds) {
  EXPECT_EQ(breaking_points(limit_curve_of({5, 5, 5, 5, 5}), 1e-6), (Indices{0, 4}));
}

TEST(BreakingPoints, OfARampThatGoesOnUpwardsAreItsEnds) {
  EXPECT_EQ(breaking_points(limit_curve_of({1, 2, 4, 8, 9, 10}), 0.5), (Indices{0, 5}));
}

TEST(BreakingPoints, AreTheTurnsOfASawtooth) {
  EXPECT_EQ(breaking_points(limit_curve_of({9, 5, 1, 5, 9, 5, 1, 5, 9}), 1.0),
            (Indices{0, 2, 4, 6, 8}));
}

TEST(BreakingPoints, AreNotTurnsBelowTheScreeningValue) {
  EXPECT_EQ(breaking_points(limit_curve_of({9, 5, 1, 5, 9, 8.9, 9, 8.9, 9}), 1.0),
            (Indices{0, 2, 4, 8}));
}

TEST(BreakingPoints, AreBothEndsOfAPlateau) {
  EXPECT_EQ(breaking_points(limit_curve_of({1, 5, 9, 9, 9, 5, 1}), 1.0), (Indices{0, 2, 4, 6}));
}

// The Sigmoid paper's count at 0.5 um, 1 ms and 100 mm/s; u runs from 0 to 1. Any screening value
// from 1950 to 5370 mm/s gives it on this scan.
TEST(BreakingPoints, OfTheButterflyAreThePapers37) {
  const auto curve = smooth_curve(curves::testing::shipped_curve("butterfly"));
  const VelocityLimitCurve limit_curve = scan_feedrate(curve, {.feedrate_mm_s = 100.0,
                                                               .along = {.jerk_mm_s3 = 55'000.0},
                                                               .period_s = 0.001,
                                                               .chord_tolerance_mm = 5e-4});
  for (const double screening_mm_s : {2100.0, 3000.0, 5000.0}) {
    EXPECT_EQ(breaking_points(limit_curve, screening_mm_s).size(), 37U) << screening_mm_s;
  }
}

TEST(Valleys, AreTheLowestPointsBetweenHills) {
  const VelocityLimitCurve limit_curve = limit_curve_of({9, 5, 1, 5, 9, 6, 3, 6, 9});
  EXPECT_EQ(valleys(limit_curve, breaking_points(limit_curve, 0.0)), (Indices{2, 6}));
}

TEST(Valleys, LeaveOutNoise) {
  const VelocityLimitCurve limit_curve =
      limit_curve_of({9, 8.99, 9, 8.98, 9, 5, 5.01, 5, 9, 8.99, 9});
  const Indices found = valleys(limit_curve, breaking_points(limit_curve, 0.0));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(limit_curve[found[0]].v_mm_s, 5.0);
}

TEST(Valleys, OfARampAreNone) {
  const VelocityLimitCurve limit_curve = limit_curve_of({1, 2, 3, 5, 8});
  EXPECT_TRUE(valleys(limit_curve, breaking_points(limit_curve, 0.0)).empty());
}

TEST(Valleys, AreOneForEachPeriodOfACosine) {
  std::vector<double> v;
  for (int i = 0; i <= 500; ++i) {
    v.push_back(10.0 + 5.0 * std::cos(2.0 * std::numbers::pi * i / 100.0));
  }
  const VelocityLimitCurve limit_curve = limit_curve_of(v);
  const Indices found = valleys(limit_curve, breaking_points(limit_curve, 0.0));
  EXPECT_EQ(found, (Indices{50, 150, 250, 350, 450}));
}

TEST(BreakingPoints, AreTheEndsOfAScanOfTwoSamples) {
  EXPECT_EQ(breaking_points(limit_curve_of({1, 5}), 1.0), (Indices{0, 1}));
}

}  // namespace
}  // namespace kerf::lookahead::test
