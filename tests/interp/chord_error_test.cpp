// The chord error of one tick, against closed forms and many points.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/curves/shipped_curves.hpp"
#include "tests/interp/script.hpp"

namespace kerf::interp::test {
namespace {

TEST(ChordError, OfAnArcIsTheSagittaOfOneTick) {
  const double radius = 10.0;
  const auto arc =
      Arc::make({.start_mm = {radius, 0, 0}, .end_mm = {0, radius, 0}, .centre_mm = {0, 0, 0}})
          .value();
  Script script({radius, 0, 0});
  script.curve(arc);
  script.hill(arc.length_mm(), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  double s_before = 0.0;
  double largest = 0.0;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    const double half_angle = 0.5 * (setpoint.s_mm - s_before) / radius;
    const double sagitta = radius * (1.0 - std::cos(half_angle));
    ASSERT_NEAR(script.interpolator().chord_error_mm(), sagitta, 1e-9);
    largest = std::max(largest, sagitta);
    s_before = setpoint.s_mm;
  }
  EXPECT_GT(largest, 1e-6);
}

TEST(ChordError, OfALineIsNothing) {
  Script script;
  script.curve(line({0, 0, 0}, {3, 4, 5}));
  script.hill(std::sqrt(50.0), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    ASSERT_NEAR(script.interpolator().chord_error_mm(), 0.0, 1e-12);
  }
}

TEST(ChordError, OfACornerPassedBetweenTicksIsTheCornersDistance) {
  Script script;
  const double v = 40.0;
  script.curve(line({0, 0, 0}, {1.02, 0, 0}));
  script.law(Transition::cruise(v, 1.02));
  script.curve(line({1.02, 0, 0}, {1.02, 1, 0}));
  script.law(Transition::cruise(v, 1.0));
  Setpoint setpoint;
  double largest = 0.0;
  for (int i = 0; i < 50; ++i) {
    script.interpolator().next(setpoint);
    largest = std::max(largest, script.interpolator().chord_error_mm());
  }
  // Ticks 0.02 mm before and after a right angle: its height over the hypotenuse.
  EXPECT_NEAR(largest, 0.02 / std::sqrt(2.0), 1e-9);
}

// The largest distance of 64 points of the curve between two arc lengths from their chord.
double many_points_mm(const NurbsCurve& curve, double s_from_mm, double s_to_mm) {
  const Position from = curve.at(s_from_mm);
  const Position to = curve.at(s_to_mm);
  const Eigen::Vector3d chord = curves::vec(to) - curves::vec(from);
  double largest = 0.0;
  for (int i = 1; i < 64 && chord.norm() > 0.0; ++i) {
    const Position point = curve.at(s_from_mm + (s_to_mm - s_from_mm) * i / 64.0);
    const Eigen::Vector3d offset = curves::vec(point) - curves::vec(from);
    const double share = std::clamp(offset.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    largest = std::max(largest, (offset - share * chord).norm());
  }
  return largest;
}

TEST(ChordError, OfACurveIsWhatManyPointsGive) {
  const auto parts = NurbsCurve::make(curves::testing::shipped_curve("rational4")).value();
  const NurbsCurve& curve = parts.front();
  Script script(curve.at(0.0));
  script.curve(curve);
  script.hill(curve.length_mm(), Profile{ProfileKind::s_curve});
  script.rest(0.0, true);
  Setpoint setpoint;
  double s_before = 0.0;
  double largest = 0.0;
  while (script.interpolator().next(setpoint) == TickStatus::running) {
    const double brute = many_points_mm(curve, s_before, setpoint.s_mm);
    ASSERT_NEAR(script.interpolator().chord_error_mm(), brute, 1e-10 + 0.01 * brute);
    largest = std::max(largest, brute);
    s_before = setpoint.s_mm;
  }
  EXPECT_GT(largest, 1e-6);
}

// The pieces of a curve are short where it is sharp: a tick may pass several of them.
TEST(ChordError, LooksAtPiecesThatATickPassesOver) {
  const auto parts = NurbsCurve::make(curves::testing::shipped_curve("butterfly")).value();
  const NurbsCurve& curve = parts.front();
  const double tick_mm = curve.length_mm() / 150.3;
  Script script(curve.at(0.0));
  script.curve(curve);
  script.law(Transition::cruise(tick_mm / kTs, curve.length_mm()));
  Setpoint setpoint;
  ASSERT_EQ(script.interpolator().next(setpoint), TickStatus::running);
  std::size_t max_passed = 0;
  for (double s = 0.0; s + tick_mm < curve.length_mm(); s += tick_mm) {
    ASSERT_EQ(script.interpolator().next(setpoint), TickStatus::running);
    max_passed = std::max(max_passed, curve.piece_index(s + tick_mm) - curve.piece_index(s));
    const double brute = many_points_mm(curve, s, s + tick_mm);
    ASSERT_NEAR(script.interpolator().chord_error_mm(), brute, 0.1 * brute) << setpoint.tick;
  }
  EXPECT_GE(max_passed, 5U);
}

TEST(ChordError, LooksAtBlocksThatATickPassesOver) {
  Script script;
  const std::vector<Position> corners{
      {0, 0, 0}, {1.005, 0, 0}, {1.02, 0, 0}, {1.02, 0.01, 0}, {1.0, 0.01, 0}};
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Line leg = line(corners[i - 1], corners[i]);
    script.curve(leg);
    script.law(Transition::cruise(40.0, leg.length_mm()));
  }
  Setpoint setpoint;
  double largest = 0.0;
  for (int i = 0; i < 27; ++i) {
    script.interpolator().next(setpoint);
    largest = std::max(largest, script.interpolator().chord_error_mm());
  }
  // Ticks at (1, 0) and (1.01, 0.01): the junction of the two blocks between lies at (1.02, 0).
  EXPECT_NEAR(largest, 0.02 / std::sqrt(2.0), 1e-9);
}

}  // namespace
}  // namespace kerf::interp::test
