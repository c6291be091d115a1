// The feedrate at a joint, against the papers' figures, closed forms, and ticks laid over the joint
// at every phase.
#include "lookahead/junction.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/lookahead/blocks.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kPerMinute = 60.0;
constexpr double kTs = 0.001;

// Chen, Yeh and Sun: 12.5 m/s2 on each axis, ticks of 1 ms, no bound on the corner but this.
PlanLimits quintic_paper() {
  return axis_limits({.acceleration_mm_s2 = 12'500.0});
}

BlockEnd straight(double angle_rad) {
  return {.tangent = {std::cos(angle_rad), std::sin(angle_rad), 0.0}};
}

double corner_of(const Position& before, const Position& at, const Position& after) {
  const auto blocks = blocks_of({line_move({before, at}), line_move({at, after})}, quintic_paper());
  return corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, quintic_paper());
}

struct Differences {
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = 0.0;
};

// The largest differences on any axis of ticks that pass the joint of two blocks at constant
// feedrate, for many phases of the ticks to the joint.
Differences largest_differences(const Block& before, const Block& after, double feedrate_mm_s) {
  const auto at = [&](double t) {
    const double s = feedrate_mm_s * t;
    return s < 0.0 ? curves::position_at(before.curve, before.length_mm + s)
                   : curves::position_at(after.curve, s);
  };
  Differences largest;
  for (int phase = 0; phase <= 100; ++phase) {
    for (int first = -4; first <= 1; ++first) {
      std::array<Position, 4> x{};
      for (int i = 0; i < 4; ++i) {
        x[static_cast<std::size_t>(i)] = at((first + i + phase / 100.0) * kTs);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        const double a = (x[2][k] - 2.0 * x[1][k] + x[0][k]) / (kTs * kTs);
        const double j = (x[3][k] - 3.0 * (x[2][k] - x[1][k]) - x[0][k]) / (kTs * kTs * kTs);
        largest.acceleration_mm_s2 = std::max(largest.acceleration_mm_s2, std::abs(a));
        largest.jerk_mm_s3 = std::max(largest.jerk_mm_s3, std::abs(j));
      }
    }
  }
  return largest;
}

// How far the path leaves the chord of any tick that sees the joint, passed at constant feedrate.
double largest_chord_error_mm(const Block& before, const Block& after, double feedrate_mm_s) {
  const auto at = [&](double s) {
    const Position point = s < 0.0 ? curves::position_at(before.curve, before.length_mm + s)
                                   : curves::position_at(after.curve, s);
    return Eigen::Vector3d(curves::vec(point));
  };
  const double tick_mm = feedrate_mm_s * kTs;
  double largest = 0.0;
  for (int phase = 0; phase <= 100; ++phase) {
    const double s_from = -tick_mm * phase / 100.0;
    const Eigen::Vector3d from = at(s_from);
    const Eigen::Vector3d chord = at(s_from + tick_mm) - from;
    for (int i = 1; i < 100; ++i) {
      const Eigen::Vector3d offset = at(s_from + tick_mm * i / 100.0) - from;
      const double share = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
      largest = std::max(largest, (offset - share * chord).norm());
    }
  }
  return largest;
}

TEST(Junction, OfARightAngleThatBisectsTheAxesIsThePapersCornerD) {
  constexpr double kQuarter = std::numbers::pi / 4.0;
  const double f = corner_feedrate_mm_s(straight(kQuarter), straight(-kQuarter), quintic_paper());
  EXPECT_NEAR(f * kPerMinute, 12.5 / std::sqrt(2.0) * kPerMinute, 1e-9);
  EXPECT_NEAR(f * kPerMinute, 530.33, 0.005);
}

// The corners of programs/polygon.ngc, which are ours, made for the feedrates of the paper's
// table 2.
TEST(Junction, OfThePolygonHasThePapersCornerFeedrates) {
  const Position a{5.001, 40.0, 0.0};
  const Position b{30.904, 48.566, 0.0};
  const Position c{42.936, 32.591, 0.0};
  const Position d{48.111, 51.909, 0.0};
  const Position e{92.807, 29.495, 0.0};
  const Position f{49.266, 4.915, 0.0};
  EXPECT_NEAR(corner_of(a, b, c) * kPerMinute, 674.0, 0.5);
  EXPECT_NEAR(corner_of(b, c, d) * kPerMinute, 425.0, 0.5);
  EXPECT_NEAR(corner_of(c, d, e) * kPerMinute, 530.0, 0.5);
  EXPECT_NEAR(corner_of(d, e, f) * kPerMinute, 425.0, 0.5);
  EXPECT_NEAR(corner_of(e, f, a) * kPerMinute, 674.0, 0.5);
}

TEST(Junction, IsBoundByJerkWhereThatIsLess) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 12'500.0, .jerk_mm_s3 = 55'000.0});
  const double f = corner_feedrate_mm_s(straight(0.0), straight(0.01), limits);
  EXPECT_NEAR(f, 55'000.0 * kTs * kTs / std::sin(0.01), 1e-9);
}

// A tick that has the corner in its middle leaves it by v Ts / 2 sin(turn / 2).
TEST(Junction, IsBoundByTheChordToleranceWhereThatIsLess) {
  PlanLimits limits = quintic_paper();
  limits.chord_tolerance_mm = 1e-4;
  for (const double turn : {0.01, 0.3, 1.5, 2.8}) {
    SCOPED_TRACE(turn);
    const double f = corner_feedrate_mm_s(straight(0.4), straight(0.4 + turn), limits);
    EXPECT_NEAR(0.5 * f * kTs * std::sin(0.5 * turn), limits.chord_tolerance_mm, 1e-12);
  }
}

TEST(Junction, DoesNotAskTheChordToleranceWhereThePathIsSmooth) {
  PlanLimits limits = quintic_paper();
  limits.chord_tolerance_mm = 1e-9;
  EXPECT_EQ(corner_feedrate_mm_s(straight(0.7), straight(0.7), limits), kUnbounded);
}

TEST(Junction, TakesTheWeakestAxisThatTurns) {
  PlanLimits limits = quintic_paper();
  limits.axes[2].acceleration_mm_s2 = 1.0;  // does not turn
  limits.axes[1].acceleration_mm_s2 = 5000.0;
  constexpr double kQuarter = std::numbers::pi / 4.0;
  const double f = corner_feedrate_mm_s(straight(kQuarter), straight(-kQuarter), limits);
  EXPECT_NEAR(f, 5.0 / std::sqrt(2.0), 1e-12);
}

TEST(Junction, FallsBackToThePathsLimitsWhereAnAxisHasNone) {
  const PlanLimits limits = path_limits({.acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 40'000.0});
  const double f = corner_feedrate_mm_s(straight(0.0), straight(0.02), limits);
  EXPECT_NEAR(f, 40'000.0 * kTs * kTs / std::sin(0.02), 1e-9);
  PlanLimits partly = limits;
  partly.axes[1].jerk_mm_s3 = 10'000.0;
  EXPECT_NEAR(corner_feedrate_mm_s(straight(0.0), straight(0.02), partly),
              10'000.0 * kTs * kTs / std::sin(0.02), 1e-9);
}

TEST(Junction, OfCollinearLinesDoesNotBind) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 20, 30}}, 50.0), line_move({{10, 20, 30}, {11, 22, 33}}, 40.0)},
      limits);
  EXPECT_EQ(corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits), kUnbounded);
  const Junction joint = junction({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_EQ(joint.feedrate_mm_s, 40.0);
  EXPECT_EQ(joint.coast_s, 0.0);
}

struct JointCase {
  const char* name;
  parser::Move before;
  parser::Move after;
  MotionLimits axis;
  bool jerk_binds;
};

std::vector<JointCase> joint_cases() {
  const parser::Move quarter =
      arc_move({.ends = {{10, 0, 0}, {0, 10, 0}}, .centre = {0, 0, 0}});  // ends towards -x
  const parser::Move half_circle_on =
      arc_move({.ends = {{0, 10, 0}, {0, 30, 0}}, .centre = {0, 20, 0}, .clockwise = true});
  return {
      {"corner, acceleration",
       line_move({{0, 0, 0}, {10, 0, 0}}),
       line_move({{10, 0, 0}, {13, 4, 0}}),
       {.acceleration_mm_s2 = 5000.0},
       false},
      {"corner, jerk",
       line_move({{0, 0, 0}, {10, 0, 0}}),
       line_move({{10, 0, 0}, {20, 1, 0}}),
       {.acceleration_mm_s2 = 1e6, .jerk_mm_s3 = 5e6},
       true},
      {"tangent arc into line, jerk",
       quarter,
       line_move({{0, 10, 0}, {-20, 10, 0}}),
       {.jerk_mm_s3 = 2e5},
       true},
      {"tangent S of two arcs, jerk", quarter, half_circle_on, {.jerk_mm_s3 = 2e5}, true},
      {"arc into line with a corner",
       quarter,
       line_move({{0, 10, 0}, {-20, 11, 0}}),
       {.jerk_mm_s3 = 5e6},
       true},
  };
}

TEST(Junction, KeepsItsBoundInTicksAtEveryPhaseAndNearlyReachesIt) {
  for (const JointCase& joint : joint_cases()) {
    SCOPED_TRACE(joint.name);
    PlanLimits limits = axis_limits(joint.axis);
    const auto blocks = blocks_of({joint.before, joint.after}, limits);
    const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
    ASSERT_TRUE(std::isfinite(f));
    const Differences found = largest_differences(blocks[0], blocks[1], f);
    EXPECT_LE(found.acceleration_mm_s2, joint.axis.acceleration_mm_s2 * (1.0 + 1e-6));
    EXPECT_LE(found.jerk_mm_s3, joint.axis.jerk_mm_s3 * (1.0 + 1e-6));
    if (joint.jerk_binds) {
      EXPECT_GE(found.jerk_mm_s3, 0.75 * joint.axis.jerk_mm_s3);
    } else {
      EXPECT_GE(found.acceleration_mm_s2, 0.999 * joint.axis.acceleration_mm_s2);
    }
  }
}

TEST(Junction, KeepsTheChordToleranceInTicksAtEveryPhaseAndNearlyReachesIt) {
  for (const JointCase& joint : joint_cases()) {
    SCOPED_TRACE(joint.name);
    PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1e7, .jerk_mm_s3 = 1e10});
    limits.chord_tolerance_mm = 1e-3;
    const auto blocks = blocks_of({joint.before, joint.after}, limits);
    const double f = corner_feedrate_mm_s(blocks[0].end, blocks[1].begin, limits);
    ASSERT_TRUE(std::isfinite(f));
    const double found_mm = largest_chord_error_mm(blocks[0], blocks[1], f);
    EXPECT_LE(found_mm, limits.chord_tolerance_mm * (1.0 + 1e-6));
    EXPECT_GE(found_mm, 0.85 * limits.chord_tolerance_mm);
  }
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
  const Junction joint = junction({.before = &square[0], .after = &square[1]}, limits);
  EXPECT_EQ(joint.feedrate_mm_s, 0.0);
  EXPECT_EQ(joint.coast_s, 0.0);
}

TEST(Junction, PassesACornerThatIsWorthIt) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55'000.0});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 0, 0}}, 50.0), line_move({{10, 0, 0}, {20, 0.02, 0}}, 50.0)},
      limits);
  const Junction joint = junction({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_NEAR(joint.feedrate_mm_s, 0.055 / 0.002, 1e-3);
  EXPECT_NEAR(joint.coast_s, 3.0 * kTs, 1e-15);
}

TEST(Junction, IsAStopBehindABlockWithExactStop) {
  const PlanLimits limits = axis_limits({.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e4});
  parser::Move first = line_move({{0, 0, 0}, {10, 0, 0}}, 50.0);
  first.mode = parser::PathMode::exact_stop;
  const auto blocks = blocks_of({first, line_move({{10, 0, 0}, {20, 0, 0}}, 50.0)}, limits);
  EXPECT_EQ(junction({.before = &blocks[0], .after = &blocks[1]}, limits).feedrate_mm_s, 0.0);
}

TEST(Junction, CoastsNoFasterThanTwoCoastsFitIntoTheShorterBlock) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 500.0, .acceleration_mm_s2 = 1e5, .jerk_mm_s3 = 1e5});
  const double length = 0.06;
  const auto blocks = blocks_of({line_move({{0, 0, 0}, {10, 0, 0}}, 400.0),
                                 line_move({{10, 0, 0}, {10 + length, 1e-4 * length, 0}}, 400.0)},
                                limits);
  const Junction joint = junction({.before = &blocks[0], .after = &blocks[1]}, limits);
  EXPECT_GT(joint.feedrate_mm_s, 0.0);
  EXPECT_LE(2.0 * joint.coast_s * joint.feedrate_mm_s, blocks[1].length_mm);
  EXPECT_GE(2.0 * joint.coast_s * joint.feedrate_mm_s, 0.999 * blocks[1].length_mm);
}

TEST(Junction, PassesACornerWhereNothingLimitsJerk) {
  const PlanLimits limits = axis_limits({.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0});
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 0, 0}}, 50.0), line_move({{10, 0, 0}, {20, 1, 0}}, 50.0)},
      limits);
  const Junction joint = junction({.before = &blocks[0], .after = &blocks[1]}, limits);
  // |du| of y is 1 / sqrt(101), and A Ts / |du| = 3 mm/s sqrt(101).
  EXPECT_NEAR(joint.feedrate_mm_s, 3.0 * std::sqrt(101.0), 1e-9);
}

}  // namespace
}  // namespace kerf::lookahead::test
