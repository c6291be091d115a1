// The limits of a block: an axis that moves at feedrate v with a and j along the path at their
// bounds stays within its own, by finite differences.
#include "lookahead/path/block_limits.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/blocks.hpp"

namespace kerf::lookahead::test {
namespace {

struct PathState {
  double v, a, j;
};

// Derivatives by time of an axis' position while s(t) = s0 + v t + a t^2/2 + j t^3/6, at t = 0, by
// central differences.
struct AxisState {
  double v, a, j;
};
AxisState axis_state(const std::function<double(double)>& x_of_s, double s0,
                     const PathState& motion) {
  const double h = 2e-4;
  const auto x = [&](double t) {
    return x_of_s(s0 + t * (motion.v + t * (motion.a / 2.0 + t * motion.j / 6.0)));
  };
  return {(x(h) - x(-h)) / (2.0 * h), (x(h) - 2.0 * x(0) + x(-h)) / (h * h),
          (x(2 * h) - 2.0 * x(h) + 2.0 * x(-h) - x(-2 * h)) / (2.0 * h * h * h)};
}

TEST(LineLimits, AreTheAxesDividedByTheirShares) {
  PlanLimits limits;
  limits.axes[0] = {.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4};
  limits.axes[1] = {.velocity_mm_s = 80.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e3};
  const auto line = curves::Line::between({0, 0, 0}, {3, 4, 0}).value();
  const BlockLimits found = line_limits(line, kUnbounded, limits);
  EXPECT_DOUBLE_EQ(found.feedrate_mm_s, 80.0 / 0.8);
  EXPECT_DOUBLE_EQ(found.ramp.acceleration_mm_s2, 1000.0 / 0.6);
  EXPECT_DOUBLE_EQ(found.ramp.jerk_mm_s3, 5e3 / 0.8);
}

TEST(LineLimits, LeaveOutAnAxisThatDoesNotMove) {
  PlanLimits limits;
  limits.axes[2] = {.velocity_mm_s = 1.0, .acceleration_mm_s2 = 1.0, .jerk_mm_s3 = 1.0};
  const auto line = curves::Line::between({0, 0, 5}, {3, 4, 5}).value();
  const BlockLimits found = line_limits(line, 42.0, limits);
  EXPECT_EQ(found.feedrate_mm_s, 42.0);
  EXPECT_EQ(found.ramp.acceleration_mm_s2, kUnbounded);
  EXPECT_EQ(found.ramp.jerk_mm_s3, kUnbounded);
}

TEST(LineLimits, AreThePathsWhereTheseAreLower) {
  PlanLimits limits =
      axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  limits.path = {.velocity_mm_s = 20.0, .acceleration_mm_s2 = 30.0, .jerk_mm_s3 = 40.0};
  const auto line = curves::Line::between({0, 0, 0}, {1, 0, 0}).value();
  const BlockLimits found = line_limits(line, kUnbounded, limits);
  EXPECT_EQ(found.feedrate_mm_s, 20.0);
  EXPECT_EQ(found.ramp.acceleration_mm_s2, 30.0);
  EXPECT_EQ(found.ramp.jerk_mm_s3, 40.0);
}

// Every combination of a and j at their bounds and of v up to its bound, at many angles.
void expect_axes_keep_limits(const curves::Arc& arc, const PlanLimits& limits) {
  const BlockLimits block = arc_limits(bend_of(arc), kUnbounded, limits);
  ASSERT_TRUE(block.feedrate_mm_s > 0.0 && std::isfinite(block.feedrate_mm_s));
  ASSERT_TRUE(block.ramp.acceleration_mm_s2 > 0.0);
  ASSERT_TRUE(block.ramp.jerk_mm_s3 > 0.0);
  for (const double share : {1.0, 0.7, 0.3}) {
    for (const double a_sign : {-1.0, 0.0, 1.0}) {
      for (const double j_sign : {-1.0, 0.0, 1.0}) {
        const PathState motion{share * block.feedrate_mm_s, a_sign * block.ramp.acceleration_mm_s2,
                               j_sign * block.ramp.jerk_mm_s3};
        for (int i = 10; i <= 190; ++i) {
          const double s0 = arc.length_mm() * i / 200.0;
          for (std::size_t k = 0; k < 3; ++k) {
            const AxisState found = axis_state([&](double s) { return arc.at(s)[k]; }, s0, motion);
            const MotionLimits& limit = limits.axes[k];
            ASSERT_LE(std::abs(found.v), limit.velocity_mm_s * 1.001) << k << " " << i;
            ASSERT_LE(std::abs(found.a), limit.acceleration_mm_s2 * 1.001) << k << " " << i;
            ASSERT_LE(std::abs(found.j), limit.jerk_mm_s3 * 1.005) << k << " " << i;
          }
        }
      }
    }
  }
}

TEST(ArcLimits, KeepEveryAxisWithinItsOwnOnACircle) {
  const auto arc =
      curves::Arc::make({.start_mm = {20, 0, 0}, .end_mm = {20, 0, 0}, .centre_mm = {0, 0, 0}})
          .value();
  expect_axes_keep_limits(
      arc, axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4}));
  expect_axes_keep_limits(
      arc, axis_limits({.velocity_mm_s = 20.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4}));
  expect_axes_keep_limits(
      arc, axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 5000.0, .jerk_mm_s3 = 5e3}));
}

TEST(ArcLimits, KeepEveryAxisWithinItsOwnOnAHelixInEachPlane) {
  PlanLimits limits;
  limits.axes = {
      MotionLimits{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 800.0, .jerk_mm_s3 = 2e4},
      MotionLimits{.velocity_mm_s = 150.0, .acceleration_mm_s2 = 1200.0, .jerk_mm_s3 = 4e4},
      MotionLimits{.velocity_mm_s = 40.0, .acceleration_mm_s2 = 300.0, .jerk_mm_s3 = 1e4}};
  for (int normal = 0; normal < 3; ++normal) {
    SCOPED_TRACE(normal);
    Position start{0, 0, 0};
    start[static_cast<std::size_t>((normal + 1) % 3)] = 15.0;
    Position end = start;
    end[static_cast<std::size_t>(normal)] = 12.0;
    const auto arc = curves::Arc::make({.start_mm = start,
                                        .end_mm = end,
                                        .centre_mm = {0, 0, 0},
                                        .normal_axis = normal,
                                        .clockwise = true})
                         .value();
    expect_axes_keep_limits(arc, limits);
  }
}

TEST(ArcLimits, BendIsTheArcsOwnDerivatives) {
  const auto arc =
      curves::Arc::make({.start_mm = {7, 0, 0}, .end_mm = {0, 7, 5}, .centre_mm = {0, 0, 0}})
          .value();
  const Bend bend = bend_of(arc);
  const auto path = arc.derivatives_at(3.0);
  EXPECT_NEAR(bend.curvature_per_mm, curves::vec(path.second_per_mm).norm(), 1e-14);
  EXPECT_NEAR(bend.third_per_mm2, curves::vec(path.third_per_mm2).norm(), 1e-14);
  EXPECT_NEAR(bend.normal_share, 5.0 / arc.length_mm(), 1e-14);
}

TEST(ArcLimits, KeepTheChordToleranceInOneTick) {
  PlanLimits limits;
  limits.chord_tolerance_mm = 5e-4;
  const double radius = 3.0;
  const auto arc =
      curves::Arc::make(
          {.start_mm = {radius, 0, 0}, .end_mm = {radius, 0, 0}, .centre_mm = {0, 0, 0}})
          .value();
  const double v = arc_limits(bend_of(arc), kUnbounded, limits).feedrate_mm_s;
  const double half_angle = 0.5 * v * limits.period_s / radius;
  EXPECT_LE(radius * (1.0 - std::cos(half_angle)), limits.chord_tolerance_mm * (1.0 + 1e-9));
  EXPECT_GE(radius * (1.0 - std::cos(half_angle)), limits.chord_tolerance_mm * 0.999);
}

TEST(ArcLimits, KeepEveryAxisWithinItsOwnOnARadiusThatChanges) {
  PlanLimits limits =
      axis_limits({.velocity_mm_s = 300.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 2e4});
  // Nearly a full circle whose ends do not meet: a spiral.
  const auto blocks =
      blocks_of({arc_move({.ends = {{10, 0, 0}, {10.02, -0.5, 2}}, .centre = {0, 0, 0}})}, limits);
  ASSERT_EQ(blocks.size(), 1U);
  ASSERT_TRUE(std::holds_alternative<curves::NurbsCurve>(blocks[0].curve));
  const BlockLimits& block = blocks[0].limits;
  for (const double sign : {-1.0, 1.0}) {
    for (int i = 10; i <= 190; ++i) {
      const double s0 = blocks[0].length_mm * i / 200.0;
      for (std::size_t k = 0; k < 3; ++k) {
        const AxisState found =
            axis_state([&](double s) { return curves::position_at(blocks[0].curve, s)[k]; }, s0,
                       {block.feedrate_mm_s, sign * block.ramp.acceleration_mm_s2,
                        sign * block.ramp.jerk_mm_s3});
        EXPECT_LE(std::abs(found.a), 1000.0 * 1.001);
        EXPECT_LE(std::abs(found.j), 2e4 * 1.005);
      }
    }
  }
}

TEST(NurbsLimits, TakeThePathAndTheWeakestOfTheAxesThatMove) {
  PlanLimits limits =
      axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  limits.axes[1].jerk_mm_s3 = 2e3;
  limits.axes[2] = {.velocity_mm_s = 1.0, .acceleration_mm_s2 = 1.0, .jerk_mm_s3 = 1.0};
  limits.path.acceleration_mm_s2 = 700.0;
  const auto curve =
      curves::NurbsCurve::make(curves::testing::shipped_curve("butterfly"));  // in X and Y
  ASSERT_TRUE(curve.has_value());
  const BlockLimits found = nurbs_limits(curve->front(), 60.0, limits);
  EXPECT_EQ(found.feedrate_mm_s, 60.0);
  EXPECT_EQ(found.ramp.acceleration_mm_s2, 700.0);
  EXPECT_EQ(found.ramp.jerk_mm_s3, 2e3);
}

}  // namespace
}  // namespace kerf::lookahead::test
