#include "curves/arc.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/curves/distance.hpp"

namespace kerf::curves {
namespace {

constexpr double kPi = std::numbers::pi;

Arc quarter(int normal_axis, bool clockwise) {
  // From the plane's first axis to its second (or to minus the second), radius 5 about the zero.
  ArcShape shape;
  shape.normal_axis = normal_axis;
  shape.clockwise = clockwise;
  shape.start_mm[static_cast<std::size_t>((normal_axis + 1) % 3)] = 5.0;
  shape.end_mm[static_cast<std::size_t>((normal_axis + 2) % 3)] = clockwise ? -5.0 : 5.0;
  return Arc::make(shape).value();
}

TEST(Arc, TurnsRightHandedAboutEachAxis) {
  // Counter-clockwise quarters: x to y about z, y to z about x, z to x about y.
  const double half = 5.0 / std::numbers::sqrt2;
  EXPECT_LT(distance_mm(quarter(2, false).at(1.25 * kPi), {half, half, 0.0}), 1e-14);
  EXPECT_LT(distance_mm(quarter(0, false).at(1.25 * kPi), {0.0, half, half}), 1e-14);
  EXPECT_LT(distance_mm(quarter(1, false).at(1.25 * kPi), {half, 0.0, half}), 1e-14);
  EXPECT_LT(distance_mm(quarter(2, true).at(1.25 * kPi), {half, -half, 0.0}), 1e-14);
  EXPECT_LT(distance_mm(quarter(0, true).at(1.25 * kPi), {0.0, half, -half}), 1e-14);
  EXPECT_LT(distance_mm(quarter(1, true).at(1.25 * kPi), {-half, 0.0, half}), 1e-14);
  for (const int axis : {0, 1, 2}) {
    EXPECT_NEAR(quarter(axis, false).length_mm(), 2.5 * kPi, 1e-14);
    EXPECT_EQ(quarter(axis, false).normal_axis(), axis);
  }
}

TEST(Arc, TakesTheLongWayWhenTheSenseSaysSo) {
  const auto arc =
      Arc::make({.start_mm = {5.0, 0.0, 0.0}, .end_mm = {0.0, 5.0, 0.0}, .clockwise = true});
  ASSERT_TRUE(arc);
  EXPECT_NEAR(arc->length_mm(), 7.5 * kPi, 1e-13);
  EXPECT_LT(distance_mm(arc->at(5.0 * kPi), {-5.0, 0.0, 0.0}), 1e-14);
}

TEST(Arc, IsAFullCircleWhenItEndsWhereItStarts) {
  const Position start{3.0, 1.0, 2.0};
  const auto arc = Arc::make({.start_mm = start, .end_mm = start, .centre_mm = {1.0, 1.0, 0.0}});
  ASSERT_TRUE(arc);
  EXPECT_NEAR(arc->length_mm(), 4.0 * kPi, 1e-13);
  EXPECT_LT(distance_mm(arc->at(2.0 * kPi), {-1.0, 1.0, 2.0}), 1e-14);
}

TEST(Arc, AddsFullCirclesForFurtherTurns) {
  const auto arc = Arc::make({.start_mm = {2.0, 0.0, 0.0},
                              .end_mm = {0.0, 2.0, 9.0},
                              .centre_mm = {0.0, 0.0, 55.0},
                              .turns = 3});
  ASSERT_TRUE(arc);
  const double in_plane_mm = 2.0 * 4.5 * kPi;
  EXPECT_NEAR(arc->length_mm(), std::hypot(in_plane_mm, 9.0), 1e-13);
  EXPECT_NEAR(arc->in_plane_share(), in_plane_mm / arc->length_mm(), 1e-15);
  EXPECT_NEAR(arc->normal_share(), 9.0 / arc->length_mm(), 1e-15);
  // After the first full turn it is above the start.
  EXPECT_LT(distance_mm(arc->at(arc->length_mm() * 4.0 / 9.0), {2.0, 0.0, 4.0}), 1e-13);
}

TEST(Arc, EndsExactlyWhereTheProgramSays) {
  const Position start{0.1 + 3.0, 0.7, -1.1};
  const Position end{0.1 + 3.0 * std::cos(1.0), 0.7 + 3.0 * std::sin(1.0), 4.4};
  const auto arc = Arc::make({.start_mm = start, .end_mm = end, .centre_mm = {0.1, 0.7, 0.0}});
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->at(0.0), start);
  EXPECT_EQ(arc->at(-2.0), start);
  EXPECT_EQ(arc->at(arc->length_mm()), end);
  EXPECT_EQ(arc->at(2.0 * arc->length_mm()), end);
  const double just_before_mm = std::nextafter(arc->length_mm(), 0.0);
  EXPECT_LT(distance_mm(arc->at(just_before_mm), end), 1e-14);
}

TEST(Arc, MeetsBothEndsWhenTheirRadiiDifferByRounding) {
  const Position end{10.0 * std::cos(2.0) + 4e-10, 10.0 * std::sin(2.0), 0.0};
  const auto arc = Arc::make({.start_mm = {10.0, 0.0, 0.0}, .end_mm = end});
  ASSERT_TRUE(arc);
  EXPECT_EQ(arc->at(0.0), (Position{10.0, 0.0, 0.0}));
  EXPECT_LT(distance_mm(arc->at(std::nextafter(arc->length_mm(), 0.0)), end), 2e-14);
}

TEST(Arc, HasTheCurvatureOfACircle) {
  const auto arc = Arc::make({.start_mm = {4.0, 0.0, 0.0}, .end_mm = {0.0, 4.0, 0.0}});
  ASSERT_TRUE(arc);
  const double angle = 0.3;
  const PathDerivatives d = arc->derivatives_at(4.0 * angle);
  EXPECT_LT(distance_mm(d.first, {-std::sin(angle), std::cos(angle), 0.0}), 1e-15);
  EXPECT_LT(distance_mm(d.second_per_mm, {-std::cos(angle) / 4.0, -std::sin(angle) / 4.0, 0.0}),
            1e-15);
  EXPECT_LT(distance_mm(d.third_per_mm2, {std::sin(angle) / 16.0, -std::cos(angle) / 16.0, 0.0}),
            1e-15);
}

TEST(Arc, HasTheCurvatureOfAHelix) {
  // r / (r^2 + c^2) for a rise of 2 pi c per turn.
  const double r = 3.0;
  const double c = 0.5;
  const auto arc = Arc::make({.start_mm = {r, 0.0, 0.0}, .end_mm = {r, 0.0, 2.0 * kPi * c}});
  ASSERT_TRUE(arc);
  const PathDerivatives d = arc->derivatives_at(1.0);
  EXPECT_NEAR(vec(d.first).norm(), 1.0, 1e-15);
  EXPECT_NEAR(vec(d.second_per_mm).norm(), r / (r * r + c * c), 1e-15);
}

TEST(Arc, BulgesToItsExtremesAndNoFarther) {
  const auto arc = Arc::make({.start_mm = {3.0, -4.0, 1.0}, .end_mm = {3.0, 4.0, 2.0}});
  ASSERT_TRUE(arc);
  EXPECT_DOUBLE_EQ(arc->extents().max_mm[0], 5.0);
  EXPECT_DOUBLE_EQ(arc->extents().min_mm[0], 3.0);
  EXPECT_DOUBLE_EQ(arc->extents().max_mm[1], 4.0);
  EXPECT_DOUBLE_EQ(arc->extents().min_mm[1], -4.0);
  EXPECT_DOUBLE_EQ(arc->extents().min_mm[2], 1.0);
  EXPECT_DOUBLE_EQ(arc->extents().max_mm[2], 2.0);
  const auto other =
      Arc::make({.start_mm = {3.0, -4.0, 1.0}, .end_mm = {3.0, 4.0, 2.0}, .clockwise = true});
  ASSERT_TRUE(other);
  EXPECT_DOUBLE_EQ(other->extents().min_mm[0], -5.0);
  EXPECT_DOUBLE_EQ(other->extents().max_mm[0], 3.0);
  EXPECT_DOUBLE_EQ(other->extents().max_mm[1], 5.0);
  EXPECT_DOUBLE_EQ(other->extents().min_mm[1], -5.0);
}

TEST(Arc, KeepsItsDigitsWhenNearlyStraight) {
  // 1 mm of a circle of 1 km: the sagitta is chord^2 / (8 r).
  const double r = 1e6;
  const double half = 0.5;
  const double drop = half * half / (r + std::sqrt(r * r - half * half));
  const auto arc = Arc::make(
      {.start_mm = {half, -drop, 0.0}, .end_mm = {-half, -drop, 0.0}, .centre_mm = {0.0, -r, 0.0}});
  ASSERT_TRUE(arc);
  EXPECT_LT(distance_mm(arc->at(0.5 * arc->length_mm()), {0.0, 0.0, 0.0}), 1e-10);
  EXPECT_NEAR(arc->length_mm(), 2.0 * r * std::asin(half / r), 1e-12);
}

TEST(Arc, SaysWhatIsWrongWithItsNumbers) {
  const auto message = [](const ArcShape& shape) {
    const auto arc = Arc::make(shape);
    return arc ? std::string() : arc.error().message;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ArcShape good{.start_mm = {1.0, 0.0, 0.0}, .end_mm = {0.0, 1.0, 0.0}};
  EXPECT_EQ(message(good), "");
  ArcShape bad = good;
  bad.centre_mm = {1.0, 0.0, 0.0};
  EXPECT_NE(message(bad).find("no radius"), std::string::npos) << message(bad);
  bad = good;
  bad.end_mm[1] = 1.25;
  EXPECT_NE(message(bad).find("1.25 mm at its end"), std::string::npos) << message(bad);
  bad = good;
  bad.turns = 0;
  EXPECT_NE(message(bad).find("0 turns"), std::string::npos) << message(bad);
  bad = good;
  bad.normal_axis = 3;
  EXPECT_NE(message(bad).find("normal axis is 3"), std::string::npos) << message(bad);
  for (Position ArcShape::*point : {&ArcShape::start_mm, &ArcShape::end_mm, &ArcShape::centre_mm}) {
    bad = good;
    (bad.*point)[0] = nan;
    EXPECT_NE(message(bad).find("not finite"), std::string::npos) << message(bad);
  }
  bad = good;
  bad.centre_mm[2] = nan;  // the component along the normal axis is not used
  EXPECT_EQ(message(bad), "");
}

}  // namespace
}  // namespace kerf::curves
