// What curvature leaves for the feedrate, against closed forms and the curve itself.
#include "lookahead/classical/axis_limit_scan.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(AxisLimitScan, FindsNothingWhereNoAxisHasALimit) {
  const auto curve = smooth_curve(curves::testing::shipped_curve("trident7"));
  PlanLimits limits = test::path_limits({.velocity_mm_s = 100.0, .jerk_mm_s3 = 1e4});
  EXPECT_TRUE(scan_axis_limits(curve, 100.0, limits).empty());
}

// At constant feedrate an axis on a circle sees v^2 / R and v^3 / R^2.
TEST(AxisLimitScan, LeavesPartOfTheLimitsOnACircle) {
  const double radius = 5.0;
  const auto curve = smooth_curve(nurbs_circle(radius));
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4});
  const double most = std::min(std::sqrt(1000.0 * radius), std::cbrt(2e4 * radius * radius));
  for (const PathSample& at : scan_axis_limits(curve, 1000.0, limits)) {
    EXPECT_LT(at.feedrate_mm_s, 1.2 * most);  // 2^(1/4): both axes share it at 45 degrees
    EXPECT_GT(at.feedrate_mm_s, 0.7 * most);
  }
}

TEST(AxisLimitScan, MissesLittleBetweenSamples) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4});
  for (const char* name : {"butterfly", "trident7", "scroll"}) {
    const auto curve = smooth_curve(curves::testing::shipped_curve(name));
    const AxisLimitCurve axis_limits = scan_axis_limits(curve, 100.0, limits);
    for (std::size_t i = 1; i < axis_limits.size(); ++i) {
      const PathSample& a = axis_limits[i - 1];
      const PathSample& b = axis_limits[i];
      ASSERT_LE(a.s_mm, b.s_mm);
      const double v = std::min({100.0, a.feedrate_mm_s, b.feedrate_mm_s});
      for (const double share : {0.25, 0.5, 0.75}) {
        if (b.s_mm - a.s_mm < 1e-9) {
          continue;
        }
        const auto path = curve.derivatives_at(a.s_mm + share * (b.s_mm - a.s_mm));
        for (std::size_t k = 0; k < 3; ++k) {
          const double second =
              a.second_per_mm[k] + share * (b.second_per_mm[k] - a.second_per_mm[k]);
          const double third =
              a.third_per_mm2[k] + share * (b.third_per_mm2[k] - a.third_per_mm2[k]);
          EXPECT_LE(std::abs(second - path.second_per_mm[k]) * v * v, 0.003 * 1000.0) << name;
          EXPECT_LE(std::abs(third - path.third_per_mm2[k]) * v * v * v, 0.003 * 2e4) << name;
        }
      }
    }
  }
}

// Two arcs of parabolas that join with their tangents: curvature jumps from 2 to -2 per mm.
TEST(AxisLimitScan, CountsAJumpOfCurvatureAsJerkWithinThreeTicks) {
  curves::NurbsData data{.degree = 2, .points = {}, .knots = {0, 0, 0, 1, 1, 2, 2, 2}};
  for (const Position& at : {Position{-1, 1, 0}, Position{-0.5, 0, 0}, Position{0, 0, 0},
                             Position{0.5, 0, 0}, Position{1, -1, 0}}) {
    data.points.push_back({.position_mm = at});
  }
  const auto curve = smooth_curve(data);
  const PlanLimits limits = axis_limits({.jerk_mm_s3 = 1e6});
  const AxisLimitCurve axis_limits = scan_axis_limits(curve, 1000.0, limits);
  double at_jump = kUnbounded;
  for (const PathSample& at : axis_limits) {
    if (std::abs(at.s_mm - 0.5 * curve.length_mm()) < 1e-9) {
      at_jump = std::min(at_jump, at.feedrate_mm_s);
    }
  }
  EXPECT_LE(0.75 * at_jump * at_jump * 4.0 / limits.period_s, 1e6);
  EXPECT_GT(at_jump, 0.0);
}

TEST(AxisLimitScan, LowersALimitCurveAndNeverLiftsIt) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4});
  const auto curve = smooth_curve(curves::testing::shipped_curve("butterfly"));
  const VelocityLimitCurve flat{{.u = 0.0, .s_mm = 0.0, .v_mm_s = 60.0},
                                {.u = 1.0, .s_mm = curve.length_mm(), .v_mm_s = 60.0}};
  const AxisLimitCurve axis_limits = scan_axis_limits(curve, 60.0, limits);
  const VelocityLimitCurve lower = lower_limit_curve(flat, axis_limits);
  for (std::size_t i = 1; i < lower.size(); ++i) {
    EXPECT_LT(lower[i - 1].s_mm, lower[i].s_mm);
    EXPECT_LT(lower[i - 1].u, lower[i].u);
    EXPECT_LE(lower[i].v_mm_s, 60.0);
  }
  const auto lowest = [](const auto& samples, auto feedrate) {
    double v = kUnbounded;
    for (const auto& sample : samples) {
      v = std::min(v, feedrate(sample));
    }
    return v;
  };
  EXPECT_EQ(lowest(lower, [](const FeedSample& at) { return at.v_mm_s; }),
            lowest(axis_limits, [](const PathSample& at) { return at.feedrate_mm_s; }));
}

}  // namespace
}  // namespace kerf::lookahead::test
