#include "smoothing/curvature_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "smoothing/blend.hpp"
#include "smoothing/segment_builder.hpp"
#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

using curves::Position;
using curves::vec;
using parser::Move;
using parser::NurbsMove;

// Knots that clamp the curve at both ends, its inner ones each so many times.
NurbsMove spline(int degree, const std::vector<Position>& points, int times) {
  NurbsMove nurbs;
  nurbs.degree = degree;
  for (const Position& point : points) {
    nurbs.points.push_back({.position_mm = point});
  }
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  const std::size_t inner = points.size() - order;
  nurbs.knots.assign(order, 0.0);
  for (std::size_t i = 0; i < inner; ++i) {
    nurbs.knots.push_back(1.0 + std::floor(static_cast<double>(i) / times));
  }
  nurbs.knots.insert(nurbs.knots.end(), order, nurbs.knots.back() + 1.0);
  return nurbs;
}

Move move_along(const NurbsMove& nurbs, double feedrate_mm_s, double tolerance_mm) {
  Move move;
  move.shape = nurbs;
  move.start_mm = nurbs.points.front().position_mm;
  move.source.line = 1;
  move.feedrate_mm_s = feedrate_mm_s;
  move.mode = parser::PathMode::blend;
  move.blend_tolerance_mm = tolerance_mm;
  return move;
}

// Around a circle of 20 mm, in and out by 1 mm.
std::vector<Position> wavy_circle(int count) {
  std::vector<Position> points;
  for (int i = 0; i < count; ++i) {
    const double angle_rad = 0.05 * i;
    const double r_mm = 20.0 + std::sin(7.0 * angle_rad);
    points.push_back({r_mm * std::cos(angle_rad), r_mm * std::sin(angle_rad), 0.05 * i});
  }
  return points;
}

// The largest jump of the curvature vector, in the segments and between them.
double largest_jump_per_mm(const Smoothed& smoothed) {
  double largest = 0.0;
  Eigen::Vector3d before = Eigen::Vector3d::Zero();
  bool first = true;
  for (const smoothing::PathSegment& segment : smoothed.segments) {
    curves::for_each_piece(segment.curve, [&](const curves::Piece& piece) {
      const auto second = [&piece](double s_mm) {
        const curves::PathDerivatives path = curves::derivatives_at(piece, s_mm);
        return Eigen::Vector3d(vec(path.second_per_mm));
      };
      if (!first) {
        largest = std::max(largest, (second(curves::s_begin_mm(piece)) - before).norm());
      }
      first = false;
      before = second(curves::s_end_mm(piece));
    });
  }
  return largest;
}

double measured_mm(const Move& move, const Smoothed& smoothed) {
  return apart_mm(points_of(std::vector{move}), points_of(smoothed));
}

TEST(CurvatureJumps, AreThoseOfSimpleKnotsOfDegreeTwoAndOfDoubleOnesOfDegreeThree) {
  const std::vector<Position> points = wavy_circle(20);
  const auto jumps_of = [&](int degree, int times) {
    const Move move = move_along(spline(degree, points, times), 100.0, 0.0);
    const Smoothed exact = smooth({move});
    EXPECT_EQ(exact.segments.size(), 1U);
    return smoothing::curvature_jumps(std::get<curves::NurbsCurve>(exact.segments.front().curve))
        .size();
  };
  EXPECT_EQ(jumps_of(2, 1), 17U);
  EXPECT_EQ(jumps_of(3, 2), 8U);
  EXPECT_EQ(jumps_of(3, 1), 0U);
  EXPECT_EQ(jumps_of(4, 2), 0U);
}

TEST(CurvatureJumps, LeaveAFastCurveWithinTheTolerance) {
  for (const auto& [degree, times] : {std::pair(2, 1), std::pair(3, 2)}) {
    const Move move = move_along(spline(degree, wavy_circle(120), times), 200.0, 0.01);
    const Smoothed smoothed = smooth({move});
    EXPECT_LT(largest_jump_per_mm(smoothed), 1e-6);
    EXPECT_LE(smoothed.deviation.distance_mm, 0.01);
    EXPECT_LE(measured_mm(move, smoothed), smoothed.deviation.distance_mm + 3e-5);
    EXPECT_EQ(faults_of_junctions({move}, smoothed), "");
  }
}

TEST(CurvatureJumps, BecomeBlendsWhereTheyAreFarApartAndTheRestStaysAsProgrammed) {
  const Move move = move_along(spline(2, wavy_circle(120), 1), 20.0, 0.01);
  const Smoothed smoothed = smooth({move});
  EXPECT_EQ(smoothed.segments.size(), 2U * 117U + 1U);
  EXPECT_LT(largest_jump_per_mm(smoothed), 1e-6);
  // Off by what a ramp of the jump's length takes of a step: a small part of way^2 times the jump.
  EXPECT_LT(smoothed.deviation.distance_mm, 1e-6);
  EXPECT_LE(measured_mm(move, smoothed), smoothed.deviation.distance_mm + 3e-5);
}

TEST(CurvatureJumps, StayInExactPath) {
  const NurbsMove nurbs = spline(2, wavy_circle(30), 1);
  Move move = move_along(nurbs, 200.0, 0.01);
  move.mode = parser::PathMode::exact_path;
  const Smoothed smoothed = smooth({move});
  ASSERT_EQ(smoothed.segments.size(), 1U);
  EXPECT_GT(largest_jump_per_mm(smoothed), 1e-3);
  EXPECT_EQ(smoothed.deviation.distance_mm, 0.0);
}

// The ramp has the curvature and its integrals of the step: between lines of slope 1 that is
// w - 2.5 w (1 - w) (1 - 2 w) of it, the least of which is at w = (15 - sqrt(135)) / 30.
TEST(CurvatureJumps, BecomeARampBetweenALineAndATangentArc) {
  const curves::Curve line = *curves::Line::between({-10.0, 0.0, 0.0}, {});
  const parser::Move arc_after =
      arc_move({.start_mm = {}, .centre_mm = {0.0, 5.0, 0.0}, .angle_rad = 2.0}, {});
  std::vector<smoothing::PathSegment> arcs;
  ASSERT_TRUE(smoothing::append_segments(arc_after, arcs));
  const smoothing::Corner corner{.before = &line, .after = &arcs.front().curve};
  ASSERT_TRUE(smoothing::is_tangential(corner, 0.5));
  const auto blend = smoothing::make_blend(corner, 0.5);
  ASSERT_TRUE(blend);
  double most = 0.0;
  double least = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const curves::PathDerivatives path =
        blend->curve.derivatives_at(0.01 * i * blend->curve.length_mm());
    // Turning left is up at the joint.
    const double curvature =
        path.first[0] * path.second_per_mm[1] - path.first[1] * path.second_per_mm[0];
    most = std::max(most, curvature);
    least = std::min(least, curvature);
  }
  const double beyond = 0.0810;
  EXPECT_NEAR(most, 0.2 * (1.0 + beyond), 0.2 * 0.001);
  EXPECT_NEAR(least, -0.2 * beyond, 0.2 * 0.001);
}

TEST(CurvatureJumps, OfRandomSplinesAreSmoothedWithinTheTolerance) {
  for (std::uint32_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto from = [&random](double low, double high) {
      return std::uniform_real_distribution<double>(low, high)(random);
    };
    const int degree = 2 + static_cast<int>(seed % 4);
    const double step_mm = std::pow(10.0, from(-1.5, 0.3));
    const double noise_mm = step_mm * from(0.0, 0.4);
    std::vector<Position> points;
    for (int i = 0; i < 25; ++i) {
      const double angle_rad = from(0.05, 0.2) * i;
      points.push_back({step_mm * i, 5.0 * step_mm * std::sin(angle_rad) + noise_mm * from(-1, 1),
                        noise_mm * from(-1.0, 1.0)});
    }
    const double tolerance_mm = std::pow(10.0, from(-4.0, -0.7));
    const int times = 1 + static_cast<int>(seed % 3) % degree;
    const Move move =
        move_along(spline(degree, points, times), std::pow(10.0, from(0.0, 2.7)), tolerance_mm);
    const Smoothed smoothed = smooth({move});
    ASSERT_FALSE(smoothed.segments.empty());
    EXPECT_EQ(faults_of_junctions({move}, smoothed), "");
    const double apart = measured_mm(move, smoothed);
    EXPECT_LE(smoothed.deviation.distance_mm, tolerance_mm * (1.0 + 1e-9));
    EXPECT_LE(apart, smoothed.deviation.distance_mm + 3e-5);
  }
}

// Far out, where the points of a curve that is hardly one differ in their last bits or not at all.
TEST(CurvatureJumps, LoseNoCurveWhosePointsCoincide) {
  const double far_mm = 9e5;
  const double bit_mm = std::nextafter(far_mm, 2.0 * far_mm) - far_mm;
  std::mt19937 random(1);
  int made = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<Position> points;
    for (int k = 0; k < 5; ++k) {
      Position& point = points.emplace_back();
      std::ranges::generate(point, [&] { return far_mm + (random() % 4 == 0 ? bit_mm : 0.0); });
    }
    points.back() = points.front();
    NurbsMove nurbs = spline(2, points, 1);
    nurbs.points[2].weight = 0.3;
    const Move move = move_along(nurbs, 100.0, 0.01);
    std::vector<smoothing::PathSegment> exact;
    if (!smoothing::append_segments(move, exact)) {
      continue;
    }
    ++made;
    const Smoothed smoothed = smooth({move});
    ASSERT_FALSE(smoothed.segments.empty());
    EXPECT_EQ(faults_of_junctions({move}, smoothed), "");
  }
  EXPECT_GT(made, 100);
}

// Beside its points that coincide a curve of degree 9 is sampled nanometres apart. Held in the
// direction of its lines, a spline would bend there like a hook.
TEST(CurvatureJumps, LeaveNoHookWhereACurveEndsInSpansOfNanometres) {
  NurbsMove nurbs;
  nurbs.degree = 9;
  nurbs.points = {{{14.7217769202, 13.0532796253, 20.7025544261}},
                  {{-31.7355095834, 19.6217365217, -4.7059154133}},
                  {{-32.2619289572, -31.3475095931, 30.955080695}},
                  {{-32.2619289701, -31.3475096035, 30.9550807004}},
                  {{4.3657074848, -33.3180859419, -16.9210939683}},
                  {{4.3657075276, -33.3180859926, -16.9210939426}},
                  {{4.3657075276, -33.3180859926, -16.9210939426}},
                  {{4.3657075001, -33.3180859885, -16.921093908}},
                  {{-24.8859849028, 11.1093729913, 20.4599199332}},
                  {{-24.8859849028, 11.1093729913, 20.4599199332}},
                  {{23.6164414912, 15.308672491, -38.0682542454}},
                  {{23.6164414912, 15.308672491, -38.0682542454}}};
  const double knot = 0.0079766128;
  nurbs.knots.assign(10, 0.0);
  nurbs.knots.insert(nurbs.knots.end(), 2, knot);
  nurbs.knots.insert(nurbs.knots.end(), 10, 1.0 + knot);
  const Move move = move_along(nurbs, 100.0, 0.01);
  EXPECT_EQ(faults_of_junctions({move}, smooth({move})), "");
}

}  // namespace
}  // namespace kerf::test
