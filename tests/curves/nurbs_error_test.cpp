#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "curves/nurbs_curve.hpp"
#include "tests/curves/reference_nurbs.hpp"

namespace kerf::curves {
namespace {

using Where = CurveError::Where;

// A harmless quadratic with one inner knot.
NurbsData good() {
  return {.degree = 2,
          .points = {{{0.0, 0.0, 0.0}, 1.0},
                     {{1.0, 2.0, 0.0}, 1.0},
                     {{3.0, 2.0, 1.0}, 2.0},
                     {{4.0, 0.0, 0.0}, 1.0}},
          .knots = {0.0, 0.0, 0.0, 0.5, 1.0, 1.0, 1.0}};
}

void expect_error(const NurbsData& data, const std::string& part, Where where, std::size_t index) {
  const auto made = NurbsCurve::make(data);
  ASSERT_FALSE(made) << "expected: " << part;
  EXPECT_NE(made.error().message.find(part), std::string::npos) << made.error().message;
  EXPECT_EQ(made.error().where, where) << made.error().message;
  EXPECT_EQ(made.error().index, index) << made.error().message;
}

TEST(NurbsErrors, AreAbsentFromAGoodCurve) {
  EXPECT_TRUE(NurbsCurve::make(good()));
}

TEST(NurbsErrors, NameTheDegree) {
  NurbsData data = good();
  data.degree = 0;
  expect_error(data, "degree is 0", Where::whole, 0);
  data.degree = 10;
  expect_error(data, "degree is 10", Where::whole, 0);
  data.degree = -3;
  expect_error(data, "degree is -3", Where::whole, 0);
}

TEST(NurbsErrors, CountControlPointsAndKnots) {
  NurbsData data = good();
  data.degree = 4;
  expect_error(data, "4 control points, a curve of degree 4 needs at least 5", Where::whole, 0);
  data = good();
  data.knots.push_back(1.0);
  expect_error(data, "8 knots, expected 7", Where::whole, 0);
  data.knots.clear();
  expect_error(data, "0 knots, expected 7", Where::whole, 0);
}

TEST(NurbsErrors, PointAtTheKnot) {
  NurbsData data = good();
  data.knots[3] = -0.25;
  expect_error(data, "knot 4 is -0.25, less than the one before, 0", Where::knot, 3);
  data.knots[3] = std::numeric_limits<double>::quiet_NaN();
  expect_error(data, "knot 4 is nan", Where::knot, 3);
  data.knots = {0.0, 0.0, 0.1, 0.5, 1.0, 1.0, 1.0};
  expect_error(data, "first knot 0 stands 2 times, expected 3", Where::knot, 2);
  data.knots = {0.0, 0.0, 0.0, 0.5, 0.75, 1.0, 1.0};
  expect_error(data, "last knot 1 stands 2 times, expected 3", Where::knot, 4);
  data.knots.assign(7, 2.0);
  expect_error(data, "all knots are 2", Where::whole, 0);
  data.knots = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0};
  expect_error(data, "knot 0 stands more than 3 times", Where::knot, 3);
}

TEST(NurbsErrors, PointAtTheControlPoint) {
  const double infinity = std::numeric_limits<double>::infinity();
  NurbsData data = good();
  data.points[2].position_mm[1] = infinity;
  expect_error(data, "control point 3", Where::point, 2);
  data.points[2].position_mm[1] = 2e9;
  expect_error(data, "control point 3 at (3, 2e+09, 1)", Where::point, 2);
  for (const double weight : {0.0, -1.0, infinity, std::numeric_limits<double>::quiet_NaN()}) {
    data = good();
    data.points[1].weight = weight;
    expect_error(data, "control point 2 has weight", Where::point, 1);
  }
}

TEST(NurbsErrors, RefuseAJump) {
  NurbsData data{.degree = 1,
                 .points = {{{0.0, 0.0, 0.0}, 1.0},
                            {{1.0, 0.0, 0.0}, 1.0},
                            {{1.0, 0.5, 0.0}, 1.0},
                            {{2.0, 0.0, 0.0}, 1.0}},
                 .knots = {0.0, 0.0, 1.0, 1.0, 2.0, 2.0}};
  expect_error(data, "the curve jumps from (1, 0, 0) to (1, 0.5, 0)", Where::knot, 2);
  data.points[2].position_mm[1] = 0.0;
  EXPECT_TRUE(NurbsCurve::make(data));
}

TEST(NurbsErrors, RefuseACurveWithoutLength) {
  NurbsData data = good();
  for (ControlPoint& point : data.points)
    point.position_mm = {1.0, 2.0, 3.0};
  expect_error(data, "no length", Where::whole, 0);
}

// A cubic whose derivative is a square ending in a cusp: (t^2, t^3) over t in [-1, 1], moved.
NurbsData semicubical(double cusp_u, double lift) {
  // With t = u - cusp_u: control points of t^2 and t^3 + lift t by blossoming.
  NurbsData data{.degree = 3, .points = {}, .knots = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}};
  const auto blossom = [&](double a, double b, double c) {
    a -= cusp_u;
    b -= cusp_u;
    c -= cusp_u;
    data.points.push_back({{50.0 + 10.0 * (a * b + b * c + c * a) / 3.0,
                            -20.0 + 10.0 * (a * b * c + lift * (a + b + c) / 3.0), 5.0},
                           1.0});
  };
  blossom(0.0, 0.0, 0.0);
  blossom(0.0, 0.0, 1.0);
  blossom(0.0, 1.0, 1.0);
  blossom(1.0, 1.0, 1.0);
  return data;
}

TEST(NurbsErrors, CutTheCurveAtACusp) {
  for (const double u : {0.5, 0.375, 0.3, 0.123456789, 0.7}) {
    const auto made = NurbsCurve::make(semicubical(u, 0.0));
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->size(), 2U) << u;
    const NurbsCurve& before = made->front();
    const NurbsCurve& after = made->back();
    EXPECT_NEAR(before.at(before.length_mm())[0], 50.0, 1e-9);
    EXPECT_NEAR(after.at(0.0)[0], 50.0, 1e-9);
    EXPECT_LT((vec(before.at(before.length_mm())) - vec(after.at(0.0))).norm(), 1e-11);
    const double turn = vec(before.derivatives_at(before.length_mm()).first)
                            .dot(vec(after.derivatives_at(0.0).first));
    EXPECT_LT(turn, -0.99);
  }
}

// On a straight line a curve turns back between two knots, anywhere: no part holds such a place.
TEST(NurbsErrors, CutACurveThatTurnsBackOnALine) {
  std::mt19937_64 random(1);
  const auto uniform = [&random](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int n = 0; n < 3000; ++n) {
    const double size = std::pow(10.0, uniform(-3.0, 2.0));
    NurbsData data{.degree = 3, .points = {}, .knots = {0, 0, 0, 0, 1, 1, 1, 1}};
    for (int i = 0; i < 4; ++i) {
      data.points.push_back({.position_mm = {size * uniform(-1.0, 1.0), 0.0, 0.0},
                             .weight = std::pow(10.0, uniform(-1.0, 1.0))});
    }
    const auto curves = NurbsCurve::make(data);
    ASSERT_TRUE(curves);
    for (const NurbsCurve& curve : *curves) {
      const double begin = curve.derivatives_at(0.0).first[0];
      for (const NurbsPiece& piece : curve.pieces()) {
        ASSERT_GT(begin * curve.derivatives_at(piece.s_end_mm).first[0], 0.0)
            << "curve " << n << ", s " << piece.s_end_mm << " of " << curve.length_mm();
      }
    }
  }
}

TEST(NurbsErrors, SpareANearCusp) {
  // Lifted by epsilon the curve turns smoothly, about a radius of 10 epsilon^2 / 2.
  for (const double lift : {1e-2, 1e-3, 1e-4, 1e-5}) {
    const NurbsData data = semicubical(0.3, lift);
    const auto made = NurbsCurve::make(data);
    ASSERT_TRUE(made) << made.error().message;
    ASSERT_EQ(made->size(), 1U);
    EXPECT_LT(made->front().pieces().size(), 400U);
    const auto reference = testing::reference_length_mm(data, 0.0L, 0.3L) +
                           testing::reference_length_mm(data, 0.3L, 1.0L);
    EXPECT_NEAR(made->front().length_mm(), static_cast<double>(reference), 1e-9) << lift;
  }
}

TEST(NurbsErrors, CutTheCurveWhereItDoublesBack) {
  const NurbsData data{
      .degree = 2,
      .points = {{{0.0, 0.0, 0.0}, 1.0}, {{4.0, 4.0, 0.0}, 1.0}, {{1.0, 1.0, 0.0}, 1.0}},
      .knots = {0.0, 0.0, 0.0, 1.0, 1.0, 1.0}};
  const auto made = NurbsCurve::make(data);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_EQ(made->size(), 2U);
  // x = 8 u - 7 u^2 turns back at u = 4/7, x = 16/7.
  EXPECT_NEAR(made->front().length_mm(), std::sqrt(2.0) * 16.0 / 7.0, 1e-9);
  EXPECT_NEAR(made->back().length_mm(), std::sqrt(2.0) * 9.0 / 7.0, 1e-9);
}

}  // namespace
}  // namespace kerf::curves
