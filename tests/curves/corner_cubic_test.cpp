#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "curves/arc_length.hpp"
#include "curves/curve_builders.hpp"

namespace kerf::curves {
namespace {

constexpr double kSharpest_rad = 154.0 * std::numbers::pi / 180.0;

// A corner somewhere, turning by so much in a plane that lies anyhow.
CornerLines corner(double turn_rad, double way_mm, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  const Eigen::Vector3d in = Eigen::Vector3d(any(random), any(random), any(random)).normalized();
  const Eigen::Vector3d side =
      in.cross(Eigen::Vector3d(any(random), any(random), any(random))).normalized();
  return {
      .corner_mm = {100.0 * any(random), 100.0 * any(random), 100.0 * any(random)},
      .direction_in = to_position(in),
      .direction_out = to_position((std::cos(turn_rad) * in + std::sin(turn_rad) * side).eval()),
      .way_mm = way_mm};
}

NurbsCurve by_control_points(const CornerLines& lines) {
  const Position begin =
      to_position((vec(lines.corner_mm) - lines.way_mm * vec(lines.direction_in)).eval());
  const Position end =
      to_position((vec(lines.corner_mm) + lines.way_mm * vec(lines.direction_out)).eval());
  const NurbsData data{.degree = 3,
                       .points = {{.position_mm = begin},
                                  {.position_mm = lines.corner_mm},
                                  {.position_mm = lines.corner_mm},
                                  {.position_mm = end}},
                       .knots = {0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0}};
  return NurbsCurve::make(data)->front();
}

// The other map is made by halving and has been checked against quadrature by itself.
TEST(CornerCubic, IsTheNurbsOfItsControlPointsByArcLength) {
  std::mt19937_64 random(11);
  for (const double way_mm : {1e-5, 1e-3, 0.02, 0.3, 4.0, 50.0}) {
    for (int i = 0; i <= 20; ++i) {
      const CornerLines lines = corner(kSharpest_rad * std::max(i / 20.0, 1e-6), way_mm, random);
      const auto cubic = corner_cubic(lines);
      ASSERT_TRUE(cubic.has_value()) << way_mm << ' ' << i;
      const NurbsCurve other = by_control_points(lines);
      ASSERT_NEAR(cubic->length_mm(), other.length_mm(), 1e-11);
      for (int k = 0; k <= 50; ++k) {
        const double s = cubic->length_mm() * k / 50.0;
        const PathDerivatives of_cubic = cubic->derivatives_at(s);
        const PathDerivatives of_other = other.derivatives_at(s);
        EXPECT_LE((vec(of_cubic.position_mm) - vec(of_other.position_mm)).norm(), 1e-11)
            << way_mm << ' ' << i;
        // What both maps may be off by in s, and rounding of the control points.
        const double open_per_mm =
            2.0 * kArcLengthTolerance_mm * vec(of_other.third_per_mm2).norm();
        EXPECT_LE((vec(of_cubic.second_per_mm) - vec(of_other.second_per_mm)).norm(),
                  open_per_mm + 1e-8 / way_mm)
            << way_mm << ' ' << i;
      }
    }
  }
}

TEST(CornerCubic, LiesSymmetricallyAboutItsCorner) {
  std::mt19937_64 random(12);
  const CornerLines lines = corner(2.0, 0.1, random);
  const NurbsCurve cubic = *corner_cubic(lines);
  EXPECT_NEAR(cubic.s_at(0.5), 0.5 * cubic.length_mm(), 1e-15);
  for (const double s : {0.0, 0.01, 0.04, 0.05}) {
    const double before = (vec(cubic.at(s)) - vec(lines.corner_mm)).norm();
    const double after = (vec(cubic.at(cubic.length_mm() - s)) - vec(lines.corner_mm)).norm();
    EXPECT_NEAR(before, after, 1e-12);
  }
}

TEST(CornerCubic, IsNoneWhereTheLinesTurnBack) {
  EXPECT_FALSE(corner_cubic({.corner_mm = {0.0, 0.0, 0.0},
                             .direction_in = {1.0, 0.0, 0.0},
                             .direction_out = {-1.0, 0.0, 0.0},
                             .way_mm = 0.1})
                   .has_value());
}

}  // namespace
}  // namespace kerf::curves
