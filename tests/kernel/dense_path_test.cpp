// The points that ticks on singular curves are held against, by closed forms, and that what is
// wrong by little is seen.
#include "tests/kernel/dense_path.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

constexpr double kSag_mm = 1e-7;

curves::NurbsData bezier(std::vector<curves::ControlPoint> points) {
  std::vector<double> knots(points.size(), 0.0);
  knots.insert(knots.end(), points.size(), 1.0);
  return {
      .degree = static_cast<int>(points.size()) - 1, .points = std::move(points), .knots = knots};
}

curves::NurbsData quarter_circle() {
  return bezier({{{10, 0, 0}}, {{10, 10, 0}, std::numbers::sqrt2 / 2.0}, {{0, 10, 0}}});
}

TEST(DensePath, OfAQuarterCircleLiesOnItAndIsAsLong) {
  const auto path = dense_path(quarter_circle(), kSag_mm);
  for (const PathPoint& point : path) {
    EXPECT_NEAR(std::hypot(point.position_mm[0], point.position_mm[1]), 10.0, 1e-12);
  }
  EXPECT_NEAR(path.back().s_mm, 5.0 * std::numbers::pi, 1e-8);
}

// x = 6 u - 5 u^2 runs to 1.8 and back to 1.
TEST(DensePath, OfACurveThatRunsBackIsAsLongAsItsWay) {
  const auto path = dense_path(bezier({{{0, 0, 0}}, {{3, 0, 0}}, {{1, 0, 0}}}), kSag_mm);
  EXPECT_NEAR(path.back().s_mm, 2.6, 1e-8);
}

// Ticks on the quarter circle, each a quarter of a millimetre on: chord errors of h^2 / 8 R.
std::string complaint(double tolerance_mm, double beside_mm) {
  const auto path = dense_path(quarter_circle(), kSag_mm);
  DenseChecker checker(path, tolerance_mm);
  for (double s = 0.0; s < 15.0; s += 0.25) {
    interp::Setpoint setpoint;
    setpoint.s_mm = s;
    const double r = 10.0 + beside_mm;
    setpoint.position_mm = {r * std::cos(s / 10.0), r * std::sin(s / 10.0), 0.0};
    checker.add(setpoint);
  }
  return checker.complaint();
}

TEST(DenseChecker, SeesAChordErrorOneHundredthAboveTheTolerance) {
  const double error_mm = 0.25 * 0.25 / 80.0;
  EXPECT_EQ(complaint(error_mm / 0.999, 0.0), "");
  EXPECT_NE(complaint(error_mm / 1.01, 0.0), "");
}

TEST(DenseChecker, SeesATickBesideTheCurve) {
  EXPECT_EQ(complaint(1e-2, 1e-6), "");
  EXPECT_NE(complaint(1e-2, 2e-5), "");
}

}  // namespace
}  // namespace kerf::test
