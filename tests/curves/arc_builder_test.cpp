#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "curves/curve_builders.hpp"
#include "tests/curves/distance.hpp"

namespace kerf::curves {
namespace {

TEST(ArcBuilder, MakesAnExactArcOfRadiiThatAgree) {
  const auto made = make_arc({.start_mm = {5.0, 0.0, 0.0}, .end_mm = {0.0, 5.0, 0.0}});
  ASSERT_TRUE(made);
  ASSERT_TRUE(std::holds_alternative<Arc>(*made));
  EXPECT_DOUBLE_EQ(std::get<Arc>(*made).radius_mm(), 5.0);
}

TEST(ArcBuilder, MovesARoundedCentreWithoutLeavingThePath) {
  // The centre is off by 2 um along the chord: the arc still meets both ends and stays within that.
  const Position start{10.0, 0.0, 0.0};
  const Position end{10.0 * std::cos(0.5), 10.0 * std::sin(0.5), 0.0};
  const double along_x = (end[0] - start[0]) / distance_mm(start, end);
  const double along_y = (end[1] - start[1]) / distance_mm(start, end);
  const auto made = make_arc(
      {.start_mm = start, .end_mm = end, .centre_mm = {0.002 * along_x, 0.002 * along_y, 0.0}});
  ASSERT_TRUE(made);
  ASSERT_TRUE(std::holds_alternative<Arc>(*made));
  const Arc& arc = std::get<Arc>(*made);
  EXPECT_NEAR(arc.radius_mm(), 10.0, 1e-12);
  EXPECT_NEAR(arc.length_mm(), 5.0, 1e-12);
  EXPECT_EQ(arc.at(0.0), start);
  EXPECT_LT(distance_mm(arc.at(std::nextafter(arc.length_mm(), 0.0)), end), 2e-14);
}

TEST(ArcBuilder, LetsTheRadiusChangeEvenlyWhereACircleWouldNotClose) {
  // A turn that just does not close: Archimedes' spiral r = 10 + 0.01 angle /
  // sweep.
  for (const bool clockwise : {false, true}) {
    const double sense = clockwise ? -1.0 : 1.0;
    const double sweep = 2.0 * std::numbers::pi - 0.001;
    const Position end{1.0 + 10.01 * std::cos(sweep), 2.0 + sense * 10.01 * std::sin(sweep), 7.0};
    const auto made = make_arc({.start_mm = {11.0, 2.0, 3.0},
                                .end_mm = end,
                                .centre_mm = {1.0, 2.0, 0.0},
                                .clockwise = clockwise});
    ASSERT_TRUE(made);
    ASSERT_TRUE(std::holds_alternative<NurbsCurve>(*made));
    const NurbsCurve& curve = std::get<NurbsCurve>(*made);
    EXPECT_LT(distance_mm(curve.at(0.0), {11.0, 2.0, 3.0}), 1e-14);
    EXPECT_EQ(curve.at(curve.length_mm()), end);
    EXPECT_LT(distance_mm(curve.at(std::nextafter(curve.length_mm(), 0.0)), end), 1e-13);
    for (int i = 0; i <= 1000; ++i) {
      const Position p = curve.at(curve.length_mm() * i / 1000.0);
      double angle = sense * std::atan2(p[1] - 2.0, p[0] - 1.0);
      if (angle < -1e-9)
        angle += 2.0 * std::numbers::pi;
      EXPECT_NEAR(std::hypot(p[0] - 1.0, p[1] - 2.0), 10.0 + 0.01 * angle / sweep, 1e-10);
      EXPECT_NEAR(p[2], 3.0 + 4.0 * angle / sweep, 1e-10);
    }
    // Arc length: integral of sqrt(r^2 + r'^2 + z'^2), r and so the integrand nearly constant.
    const double slopes = std::pow(0.01 / sweep, 2) + std::pow(4.0 / sweep, 2);
    double simpson = 0.0;
    constexpr int kSteps = 200;
    for (int i = 0; i <= kSteps; ++i) {
      const double r = 10.0 + 0.01 * i / kSteps;
      simpson +=
          std::sqrt(r * r + slopes) * (i == 0 || i == kSteps ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0));
    }
    EXPECT_NEAR(curve.length_mm(), simpson * sweep / (3.0 * kSteps), 1e-9);
  }
}

TEST(ArcBuilder, SpiralsInEveryPlane) {
  for (const int axis : {0, 1, 2}) {
    const auto first = static_cast<std::size_t>((axis + 1) % 3);
    const auto second = static_cast<std::size_t>((axis + 2) % 3);
    ArcShape shape;
    shape.normal_axis = axis;
    shape.start_mm[first] = 10.0;
    shape.end_mm[first] = 10.5;
    shape.turns = 2;
    const auto made = make_arc(shape);
    ASSERT_TRUE(made);
    ASSERT_TRUE(std::holds_alternative<NurbsCurve>(*made));
    const PathDerivatives d = std::get<NurbsCurve>(*made).derivatives_at(0.0);
    EXPECT_NEAR(d.first[second], 1.0, 1e-4);  // off the circle by the growth, 0.5 in 4 pi 10
    EXPECT_NEAR(d.first[first], 0.5 / (4.0 * std::numbers::pi * 10.0), 1e-4);
    EXPECT_NEAR(std::get<NurbsCurve>(*made).length_mm(), 4.0 * std::numbers::pi * 10.25, 1e-3);
  }
}

TEST(ArcBuilder, PassesOnWhatIsWrong) {
  EXPECT_FALSE(make_arc({.start_mm = {1.0, 0.0, 0.0}, .end_mm = {0.0, 1.0, 0.0}, .turns = 0}));
  const auto many =
      make_arc({.start_mm = {1.0, 0.0, 0.0}, .end_mm = {1.5, 0.0, 0.0}, .turns = 5000});
  ASSERT_FALSE(many);
  EXPECT_NE(many.error().message.find("5000 turns"), std::string::npos) << many.error().message;
}

}  // namespace
}  // namespace kerf::curves
