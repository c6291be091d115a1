// The feedrate at a junction, against the papers' figures and closed forms.
#include "lookahead/path/junction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/lookahead/blocks.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kPerMinute = 60.0;

// [Quintic, section 3]: 12.5 m/s2 on each axis, ticks of 1 ms, no bound on the corner but this.
PlanLimits quintic_paper() {
  return axis_limits({.acceleration_mm_s2 = 12'500.0});
}

BlockEnd straight_end(double angle_rad) {
  return {{.first = {std::cos(angle_rad), std::sin(angle_rad), 0.0}}};
}

TEST(Junction, OfARightAngleThatBisectsTheAxesIsThePapersCornerD) {
  constexpr double kQuarter = std::numbers::pi / 4.0;
  const double f =
      corner_feedrate_mm_s(straight_end(kQuarter), straight_end(-kQuarter), quintic_paper());
  EXPECT_NEAR(f * kPerMinute, 12.5 / std::sqrt(2.0) * kPerMinute, 1e-9);
  EXPECT_NEAR(f * kPerMinute, 530.33, 0.005);
}

// The turns of programs/polygon.ngc. [Quintic, table 2] lets the velocity jump by A Ts along its
// vector: 674, 425 and 530 mm/min; here each axis may jump by A Ts, which is no slower.
TEST(Junction, OfThePolygonIsNoSlowerThanThePaperIs) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  struct Corner {
    double in_degrees;
    double out_degrees;
    double published;  // in mm/min
  };
  for (const auto& [in, out, published] :
       {Corner{236.25, 168.75, 674.0}, Corner{168.75, 45.0, 425.0}, Corner{45.0, 135.0, 530.0}}) {
    SCOPED_TRACE(published);
    const double vector_mm_s = 12.5 / std::abs(2.0 * std::sin(0.5 * (out - in) * kDegree));
    EXPECT_EQ(std::floor(vector_mm_s * kPerMinute), published);
    const double dx = std::abs(std::cos(out * kDegree) - std::cos(in * kDegree));
    const double dy = std::abs(std::sin(out * kDegree) - std::sin(in * kDegree));
    const double found = corner_feedrate_mm_s(straight_end(in * kDegree),
                                              straight_end(out * kDegree), quintic_paper());
    EXPECT_NEAR(found, 12.5 / std::max(dx, dy), 1e-9);
    EXPECT_GE(found, vector_mm_s - 1e-9);
  }
}

TEST(Junction, IsBoundByJerkWhereThatIsLess) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 12'500.0, .jerk_mm_s3 = 55'000.0});
  const double f = corner_feedrate_mm_s(straight_end(0.0), straight_end(0.01), limits);
  EXPECT_NEAR(f, 55'000.0 * kTs * kTs / std::sin(0.01), 1e-9);
}

// A tick that has the corner in its middle leaves it by v Ts / 2 sin(turn / 2).
TEST(Junction, IsBoundByTheChordToleranceWhereThatIsLess) {
  PlanLimits limits = quintic_paper();
  limits.chord_tolerance_mm = 1e-4;
  for (const double turn : {0.01, 0.3, 1.5, 2.8}) {
    SCOPED_TRACE(turn);
    const double f = corner_feedrate_mm_s(straight_end(0.4), straight_end(0.4 + turn), limits);
    EXPECT_NEAR(0.5 * f * kTs * std::sin(0.5 * turn), limits.chord_tolerance_mm, 1e-12);
  }
}

TEST(Junction, DoesNotAskTheChordToleranceWhereThePathIsSmooth) {
  PlanLimits limits = quintic_paper();
  limits.chord_tolerance_mm = 1e-9;
  EXPECT_EQ(corner_feedrate_mm_s(straight_end(0.7), straight_end(0.7), limits), kUnbounded);
}

TEST(Junction, TakesTheWeakestAxisThatTurns) {
  PlanLimits limits = quintic_paper();
  limits.axes[2].acceleration_mm_s2 = 1.0;  // does not turn
  limits.axes[1].acceleration_mm_s2 = 5000.0;
  constexpr double kQuarter = std::numbers::pi / 4.0;
  const double f = corner_feedrate_mm_s(straight_end(kQuarter), straight_end(-kQuarter), limits);
  EXPECT_NEAR(f, 5.0 / std::sqrt(2.0), 1e-12);
}

TEST(Junction, FallsBackToThePathsLimitsWhereAnAxisHasNone) {
  const PlanLimits limits = path_limits({.acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 40'000.0});
  const double f = corner_feedrate_mm_s(straight_end(0.0), straight_end(0.02), limits);
  EXPECT_NEAR(f, 40'000.0 * kTs * kTs / std::sin(0.02), 1e-9);
  PlanLimits partly = limits;
  partly.axes[1].jerk_mm_s3 = 10'000.0;
  EXPECT_NEAR(corner_feedrate_mm_s(straight_end(0.0), straight_end(0.02), partly),
              10'000.0 * kTs * kTs / std::sin(0.02), 1e-9);
}

// From a line along X on to a move of another axis alone: the feedrate along the path falls to 0
// from one tick to the next, which the limits along the path bound as they bound an axis.
TEST(Junction, IsBoundByThePathWhereItsOwnAxesComeToRest) {
  BlockEnd along_x;
  along_x.first = {1, 0, 0};
  BlockEnd at_rest;
  at_rest.extra_per_mm[3] = 1.0;
  PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1e6, .jerk_mm_s3 = 1e9});
  limits.extra[3] = {.acceleration_mm_s2 = 1e6, .jerk_mm_s3 = 1e9};
  limits.path = {.acceleration_mm_s2 = 500.0, .jerk_mm_s3 = 2e5};
  EXPECT_NEAR(corner_feedrate_mm_s(along_x, at_rest, limits), 0.2, 1e-12);  // J Ts^2
  EXPECT_NEAR(corner_feedrate_mm_s(at_rest, along_x, limits), 0.2, 1e-12);
  limits.path = {.acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 2e5};
  EXPECT_NEAR(corner_feedrate_mm_s(along_x, at_rest, limits), 0.1, 1e-12);  // A Ts
}

TEST(Junction, OfCollinearLinesDoesNotBind) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 20, 30}}, 50.0), line_move({{10, 20, 30}, {11, 22, 33}}, 40.0)},
      limits);
  EXPECT_EQ(corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits), kUnbounded);
  const Junction junction = junction_of({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_EQ(junction.feedrate_mm_s, 40.0);
  EXPECT_EQ(junction.constant_velocity_s, 0.0);
}

TEST(Junction, OfATangentArcAndLineSolvesTheCurvaturesBound) {
  const double radius = 10.0;
  const double jerk = 2e5;
  const PlanLimits limits = axis_limits({.jerk_mm_s3 = jerk});
  const auto blocks = blocks_of({arc_move({.ends = {{10, 0, 0}, {0, 10, 0}}, .centre = {0, 0, 0}}),
                                 line_move({{0, 10, 0}, {-20, 10, 0}})},
                                limits);
  const double v = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
  EXPECT_NEAR(0.75 * v * v / radius / kTs + v * v * v / (radius * radius), jerk, 1e-3);
}

TEST(Junction, StopsWherePassingDoesNotPay) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55'000.0});
  const auto square =
      blocks_of({line_move({{0, 0, 0}, {10, 0, 0}}), line_move({{10, 0, 0}, {10, 10, 0}})}, limits);
  const Junction junction = junction_of({.before = &square[0], .after = &square[1]}, limits);
  EXPECT_EQ(junction.feedrate_mm_s, 0.0);
  EXPECT_EQ(junction.constant_velocity_s, 0.0);
}

TEST(Junction, PassesACornerThatIsWorthIt) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55'000.0});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 0, 0}}, 50.0), line_move({{10, 0, 0}, {20, 0.02, 0}}, 50.0)},
      limits);
  const Junction junction = junction_of({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_NEAR(junction.feedrate_mm_s, 0.055 / 0.002, 1e-3);
  EXPECT_NEAR(junction.constant_velocity_s, 3.0 * kTs, 1e-15);
}

TEST(Junction, IsAStopBehindABlockWithExactStop) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  parser::Move first = line_move({{0, 0, 0}, {10, 0, 0}}, 50.0);
  first.mode = parser::PathMode::exact_stop;
  const auto blocks = blocks_of({first, line_move({{10, 0, 0}, {20, 0, 0}}, 50.0)}, limits);
  EXPECT_EQ(junction_of({.before = &blocks[0], .after = &blocks[1]}, limits).feedrate_mm_s, 0.0);
}

TEST(Junction, IsNoFasterThanTwoPartsAtConstantVelocityFitIntoTheShorterBlock) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 500.0, .acceleration_mm_s2 = 1e5, .jerk_mm_s3 = 1e5});
  const double length = 0.06;
  const auto blocks = blocks_of({line_move({{0, 0, 0}, {10, 0, 0}}, 400.0),
                                 line_move({{10, 0, 0}, {10 + length, 1e-4 * length, 0}}, 400.0)},
                                limits);
  const Junction junction = junction_of({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_GT(junction.feedrate_mm_s, 0.0);
  EXPECT_LE(2.0 * junction.constant_velocity_s * junction.feedrate_mm_s, blocks[1].length_mm);
  EXPECT_GE(2.0 * junction.constant_velocity_s * junction.feedrate_mm_s,
            0.999 * blocks[1].length_mm);
}

// Rest to rest a line of length L takes (32 L / J)^(1/3), passed it takes 6 Ts: of 0.02 mm 11.7 and
// of 0.002 mm 5.4 ms.
TEST(Junction, OfShortLinesIsPassedWhereAStopInEachTakesLonger) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 500.0, .acceleration_mm_s2 = 1e5, .jerk_mm_s3 = 4e5});
  const auto feedrate = [&limits](double length) {
    const auto blocks =
        blocks_of({line_move({{0, 0, 0}, {length, 0, 0}}, 100.0),
                   line_move({{length, 0, 0}, {2 * length, 0.002 * length, 0}}, 100.0)},
                  limits);
    return junction_of({.before = &blocks[0], .after = &blocks[1]}, limits).feedrate_mm_s;
  };
  EXPECT_NEAR(feedrate(0.02), 0.02 / (6.0 * kTs), 1e-6);
  EXPECT_EQ(feedrate(0.002), 0.0);
}

// 250 mm/s times 1e-11 in a tick is 0.0025 mm/s3, and times 1e-9 it is 0.25.
TEST(Junction, IsNoneWhereAllThatTurnsIsRounding) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 5e4});
  const auto junction = [&limits](double turn) {
    const auto blocks = blocks_of({line_move({{0, 0, 0}, {0.2, 0, 0}}, 250.0),
                                   line_move({{0.2, 0, 0}, {0.4, 0.2 * turn, 0}}, 250.0)},
                                  limits);
    return junction_of({.before = &blocks[0], .after = &blocks[1]}, limits);
  };
  EXPECT_EQ(junction(1e-11).feedrate_mm_s, 250.0);
  EXPECT_EQ(junction(1e-11).constant_velocity_s, 0.0);
  EXPECT_GT(junction(1e-9).constant_velocity_s, 0.0);
}

TEST(Junction, PassesACornerWhereNothingLimitsJerk) {
  const PlanLimits limits = axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 0, 0}}, 50.0), line_move({{10, 0, 0}, {20, 1, 0}}, 50.0)},
      limits);
  const Junction junction = junction_of({.before = &blocks[0], .after = &blocks[1]}, limits);
  // |du| of y is 1 / sqrt(101), and A Ts / |du| = 3 mm/s sqrt(101).
  EXPECT_NEAR(junction.feedrate_mm_s, 3.0 * std::sqrt(101.0), 1e-9);
}

}  // namespace
}  // namespace kerf::lookahead::test
