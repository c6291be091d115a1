#include "smoothing/blend.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "smoothing/segment_builder.hpp"
#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

using curves::Curve;
using curves::Line;
using curves::Position;
using curves::vec;

Curve line(const Position& from, const Position& to) {
  return *Line::between(from, to);
}

double turn_rad(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

// Twice as far along x, then on at an angle.
struct Bend {
  Curve before;
  Curve after;
};

Bend bend(double degrees) {
  return {line({-2.0, 0.0, 0.0}, {0.0, 0.0, 0.0}),
          line({0.0, 0.0, 0.0},
               {2.0 * std::cos(turn_rad(degrees)), 2.0 * std::sin(turn_rad(degrees)), 0.0})};
}

TEST(Blend, BetweenLinesLeavesTheCornerByAnEighthOfItsWayTimesTheTurn) {
  for (const double degrees : {1.0, 30.0, 90.0, 150.0}) {
    const Bend lines = bend(degrees);
    const auto blend = smoothing::make_blend({.before = &lines.before, .after = &lines.after}, 0.8);
    ASSERT_TRUE(blend.has_value());
    double nearest = HUGE_VAL;
    for (int i = 0; i <= 2000; ++i) {
      const Position at = blend->curve.at(blend->curve.length_mm() * i / 2000.0);
      nearest = std::min(nearest, vec(at).norm());
    }
    const double expected = 0.8 * 2.0 * std::sin(0.5 * turn_rad(degrees)) / 8.0;
    EXPECT_NEAR(nearest, expected, 1e-6) << degrees;
  }
}

// x = -d (1 - w)^3, y = d w^3 at a right angle: the law of two axes with one jerk each.
TEST(Blend, OfARightAngleIsTheOverlapOfTwoAxesWithConstantJerk) {
  const Bend lines = bend(90.0);
  const auto blend = smoothing::make_blend({.before = &lines.before, .after = &lines.after}, 1.0);
  ASSERT_TRUE(blend.has_value());
  for (int i = 0; i <= 10; ++i) {
    const double w = i / 10.0;
    const Position at = blend->curve.at(blend->curve.s_at(w));
    EXPECT_NEAR(at[0], -std::pow(1.0 - w, 3), 1e-9);
    EXPECT_NEAR(at[1], std::pow(w, 3), 1e-9);
  }
}

TEST(Blend, GoesOnWithDirectionAndCurvatureOfAnArcAndALine) {
  const auto arc_move = test::arc_move(
      {.start_mm = {0.0, 0.0, 0.0}, .centre_mm = {0.0, 3.0, 0.0}, .angle_rad = 1.2}, {});
  const auto end = std::get<parser::ArcMove>(arc_move.shape).end_mm;
  auto line_moves = lines_through({end, {end[0] + 5.0, end[1], end[2] + 1.0}}, {});
  const Smoothed smoothed = smooth({arc_move, line_moves[0]});
  ASSERT_EQ(smoothed.segments.size(), 3U);
  EXPECT_EQ(faults_of_junctions({arc_move, line_moves[0]}, smoothed), "");
  EXPECT_TRUE(smoothed.segments[1].continues);
  EXPECT_TRUE(smoothed.segments[2].continues);
  EXPECT_GT(smoothed.deviation.distance_mm, 0.005);
  EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
}

// The turn adds 3/4 of it over the way to the curvature at the most, and takes nothing away.
TEST(Blend, BetweenArcsThatHardlyTurnKeepsTheirCurvature) {
  const double radius = 5.0;
  const double turn = 1e-3;
  const double way = 0.2;
  const auto arc = [radius](const Position& from, double direction_rad) {
    const Position centre{from[0] - radius * std::sin(direction_rad),
                          from[1] + radius * std::cos(direction_rad), 0.0};
    std::vector<smoothing::PathSegment> segments;
    EXPECT_TRUE(smoothing::append_segments(
        arc_move({.start_mm = from, .centre_mm = centre, .angle_rad = 1.0}, {}), segments));
    return segments.front().curve;
  };
  const Curve before = arc({0.0, 0.0, 0.0}, 0.0);
  const Curve after = arc(curves::position_at(before, curves::length_mm(before)), 1.0 + turn);
  const auto blend = smoothing::make_blend({.before = &before, .after = &after}, way);
  ASSERT_TRUE(blend.has_value());
  for (int i = 0; i <= 100; ++i) {
    const double s = blend->curve.length_mm() * i / 100.0;
    const double curvature = vec(blend->curve.derivatives_at(s).second_per_mm).norm();
    EXPECT_GE(curvature, 0.999 / radius);
    EXPECT_LE(curvature, 1.001 * (1.0 / radius + 0.75 * turn / way));
  }
}

TEST(Blend, IsNoneWhereThePathTurnsBack) {
  const auto moves = lines_through({{0, 0, 0}, {10, 0, 0}, {0, 0.1, 0}}, {});
  EXPECT_EQ(smooth(moves).segments.size(), 2U);
}

TEST(Blend, TakesNoMoreThanTheFeedrateNeeds) {
  const std::vector<Position> corner{{0, 0, 0}, {10, 0, 0}, {10, 10, 0}};
  const double slow = smooth(lines_through(corner, {.corner_mm = 0.5}, 1.0)).deviation.distance_mm;
  const double fast =
      smooth(lines_through(corner, {.corner_mm = 0.5}, 100.0)).deviation.distance_mm;
  EXPECT_LT(slow, 0.01);
  EXPECT_GT(fast, 0.4);
}

TEST(Blend, LeavesNeighboursTheirHalfOfAShortLine) {
  const auto moves = lines_through({{0, 0, 0}, {10, 0, 0}, {10, 0.2, 0}, {0, 0.2, 0}},
                                   {.corner_mm = 0.5, .merge_mm = 0.0});
  const Smoothed smoothed = smooth(moves);
  EXPECT_EQ(faults_of_junctions(moves, smoothed), "");
  // 0.1 mm of the short line for each: |tB - tA| / 8 of it.
  EXPECT_NEAR(smoothed.deviation.distance_mm, 0.1 * std::sqrt(2.0) / 8.0, 1e-6);
}

TEST(Blend, MayRunAlongTheEndOfTheTravelAndNotBeyond) {
  const auto moves = lines_through({{0, 0, 0}, {0.3, 0, 0}, {0.3, 0.1, 0}}, {});
  for (const double z_max : {0.0, -0.1}) {
    smoothing::Smoother smoother(
        {.acceleration_mm_s2 = 1000.0,
         .jerk_mm_s3 = 50000.0,
         .travel = curves::Extents{.min_mm = {0.0, 0.0, -1.0}, .max_mm = {0.3, 0.1, z_max}}});
    std::size_t segments = 0;
    for (const parser::Move& move : moves) {
      ASSERT_TRUE(smoother.push(move).has_value());
    }
    smoother.flush();
    for (smoothing::Smoother::Output output; smoother.next(output);) {
      ++segments;
    }
    EXPECT_EQ(segments, z_max == 0.0 ? 3U : 2U);
  }
}

TEST(Blend, LeavesThePathAsItIsWithoutATolerance) {
  const auto moves =
      lines_through({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}}, {.corner_mm = 0.0, .merge_mm = 0.0});
  const Smoothed smoothed = smooth(moves);
  EXPECT_EQ(smoothed.segments.size(), 2U);
  EXPECT_EQ(smoothed.deviation.distance_mm, 0.0);
}

}  // namespace
}  // namespace kerf::test
