#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

NurbsMove curve_of(std::string_view text) {
  for (const Move& move : moves_of(text)) {
    if (const auto* curve = std::get_if<NurbsMove>(&move.shape)) {
      return *curve;
    }
  }
  return {};
}

// A point of the curve by the Cox-de Boor recursion [NurbsBook, equation 2.5].
double basis(const std::vector<double>& knots, std::size_t i, int degree, double u) {
  if (degree == 0) {
    return u >= knots[i] && u < knots[i + 1] ? 1.0 : 0.0;
  }
  const auto p = static_cast<std::size_t>(degree);
  const double left = knots[i + p] - knots[i];
  const double right = knots[i + p + 1] - knots[i + 1];
  return (left > 0 ? (u - knots[i]) / left * basis(knots, i, degree - 1, u) : 0.0) +
         (right > 0 ? (knots[i + p + 1] - u) / right * basis(knots, i + 1, degree - 1, u) : 0.0);
}

Point point_at(const NurbsMove& curve, double u) {
  Point sum{};
  double weights = 0.0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double share = curve.points[i].weight * basis(curve.knots, i, curve.degree, u);
    weights += share;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      sum[axis] += share * curve.points[i].position_mm[axis];
    }
  }
  return {sum[0] / weights, sum[1] / weights, sum[2] / weights};
}

TEST(CubicSpline, IsTheBezierCurveOfItsHandles) {
  const NurbsMove curve = curve_of("F60 G0 X1 Y1\nG5 X11 Y2 I2 J3 P-4 Q5");
  for (const double t : {0.0, 0.125, 0.5, 0.75}) {
    const double s = 1 - t;
    const Point point = point_at(curve, t);
    EXPECT_NEAR(point[0], s * s * s * 1 + 3 * s * s * t * 3 + 3 * s * t * t * 7 + t * t * t * 11,
                1e-12);
    EXPECT_NEAR(point[1], s * s * s * 1 + 3 * s * s * t * 4 + 3 * s * t * t * 7 + t * t * t * 2,
                1e-12);
  }
}

TEST(QuadraticSpline, IsTheParabolaOfItsHandle) {
  const NurbsMove curve = curve_of("F60 G0 X-2 Y4\nG5.1 X2 Y4 I2 J-8");
  for (const double t : {0.0, 0.25, 0.5, 0.875}) {
    const Point point = point_at(curve, t);
    EXPECT_NEAR(point[1], point[0] * point[0], 1e-12) << "y = x^2";
  }
}

TEST(UniformNurbs, OfOrderThreeWithTheRightWeightsIsAQuarterCircle) {
  const NurbsMove curve =
      curve_of("F60 G0 X10 Y0\nG5.2 P1 L3\nX10 Y10 P0.70710678118654752\nX0 Y10 P1\nG5.3");
  for (const double u : {0.0, 0.2, 0.5, 0.9}) {
    const Point point = point_at(curve, u);
    EXPECT_NEAR(point[0] * point[0] + point[1] * point[1], 100.0, 1e-9);
  }
}

TEST(Nurbs, MayBeAFullCircleOfNinePoints) {
  const std::string w = " R.70710678118654752";
  const NurbsMove curve = curve_of("F60 G0 X5 Y0\nG6.2 P3 K0 X5 Y0\nK0 X5 Y5" + w +
                                   "\nK0 X0 Y5\nK1 X-5 Y5" + w + "\nK1 X-5 Y0\nK2 X-5 Y-5" + w +
                                   "\nK2 X0 Y-5\nK3 X5 Y-5" + w + "\nK3 X5 Y0\nK4\nK4\nK4");
  EXPECT_EQ(curve.degree, 2);
  for (const double u : {0.0, 0.5, 1.0, 1.7, 2.3, 3.9}) {
    const Point point = point_at(curve, u);
    EXPECT_NEAR(point[0] * point[0] + point[1] * point[1], 25.0, 1e-9) << u;
  }
}

TEST(Nurbs, KnowsTheLinesOfItsPointsAndKnots) {
  const NurbsMove curve = curve_of("F60\nG6.2 P2 K0 X0 Y0\n\n(c)\nK0 X1\nK1 Y1\nK2\nK2");
  EXPECT_EQ(curve.point_lines, (std::vector<std::uint32_t>{2, 5, 6}));
  EXPECT_EQ(curve.knot_lines, (std::vector<std::uint32_t>{2, 5, 6, 7, 8}));
}

TEST(Nurbs, BeginsExactlyAtTheCurrentPosition) {
  const NurbsMove curve = curve_of("F60 G0 X1 Y2\nG6.2 P2 K0 X1.0005 Y1.9995\nK0 X3\nK1\nK1");
  EXPECT_EQ(curve.points[0].position_mm, (Point{1, 2, 0}));
}

TEST(Nurbs, TakesItsFirstPointAndKnotFromTheNextBlockWhereTheyAreLeftOut) {
  const NurbsMove curve = curve_of("F60 G0 X1 Y2\nG6.2 P2\nK-3 X3 Y4\nK1\nK1");
  ASSERT_EQ(curve.points.size(), 2U);
  EXPECT_EQ(curve.points[0].position_mm, (Point{1, 2, 0}));
  EXPECT_EQ(curve.knots, (std::vector<double>{-3, -3, 1, 1}));
}

TEST(Nurbs, IsInTheProgramsUnitsButItsKnotsAreNot) {
  const NurbsMove curve = curve_of("F60 G20\nG6.2 P2 K1 X0 Y0\nK1 X2 Y1\nK2\nK2");
  EXPECT_EQ(curve.points[1].position_mm, (Point{50.8, 25.4, 0}));
  EXPECT_EQ(curve.knots, (std::vector<double>{1, 1, 2, 2}));
}

TEST(Nurbs, MayHoldAKnotAsOftenAsItsOrderWhereThePointsMeet) {
  EXPECT_EQ(first_message("F60\nG6.2 P2 K0 X0 Y0\nK0 X2\nK1 X2\nK1 X4\nK2\nK2"), "no message");
}

TEST(Nurbs, OfManyPointsIsRead) {
  std::string text = "F60\nG6.2 P4 K0 X0 Y0\n";
  for (int i = 1; i < 3000; ++i) {
    text += "K" + std::to_string(std::max(0, i - 3)) + " X" + std::to_string(i) + " Y1\n";
  }
  EXPECT_EQ(curve_of(text + "K2997\nK2997\nK2997\nK2997").points.size(), 3000U);
}

TEST(Nurbs, OfAnOrderThatIsAnExtensionPutsKnotsOfAnotherOrderDownToP) {
  const std::string points = " K0 X0 Y0\nK0 X1 Y1\nK0 X2\nK0 X3\nK1 X4\nK2 X5 Y0\n";
  EXPECT_EQ(
      first_message("F60\nG6.2 P5" + points + "K3\nK3\nK3\nK3"),
      "2:6: error: G6.2: P (order) 5 needs the first 5 knots equal, found 1 in line 6 after 4 "
      "knots of 0 (Fanuc takes P 2 to 4)");
  EXPECT_EQ(
      first_message("F60\nG6.2 P4 K0 X0 Y0\nK0 X1 Y1\nK1 X2"),
      "4:1: error: G6.2: the first 4 knots must be equal, found 1 after 0; the curve begins in "
      "line 2");
}

TEST(Nurbs, WithWildWeightsIsWarnedOf) {
  EXPECT_EQ(first_message("F60\nG6.2 P2 K0 X0 Y0 R.0001\nK0 X2 R500\nK1\nK1"),
            "3:1: warning: G6.2: the weights differ by more than a factor of 1e6");
}

TEST(Nurbs, WithAnErrorRunsNoneOfItsBlocksInAnotherMode) {
  const Program program = read_program(
      "F60\nG6.2 P4 K0 X0 Y0\nK0 X1 Y1\nM8\nK0 X2 Y2\nX3 Y3\nK1 X9 Y9\nK1\nG1 X10 Y9\nM2\n");
  ASSERT_EQ(program.diagnostics.size(), 1U);
  ASSERT_EQ(program.moves.size(), 2U);
  EXPECT_EQ(program.moves[0].source.line, 9U);
  EXPECT_EQ(program.moves[0].start_mm, (Point{9, 9, 0}));
}

TEST(Nurbs, AfterACurveWithAnErrorTheNextCurveIsChecked) {
  const Program program = read_program(
      "F60\nG6.2 P2 K0 X0 Y0\nK-1 X1 Y1\nK1\nK1\nG6.2 P2 K0 X1 Y1\nK0 X2 Y2 R0\nK1\nK1\nM2\n");
  ASSERT_EQ(program.diagnostics.size(), 2U);
  EXPECT_EQ(program.diagnostics[0].source.line, 3U);
  EXPECT_EQ(program.diagnostics[1].source.line, 7U);
}

TEST(Nurbs, WhoseFirstBlockIsWrongIsNotReportedAgainByItsOtherBlocks) {
  const std::string rest = "K0 X5 Y5\nK0 X10 Y0\nK1\nK1\nK1\nG1 X5 Q1\nM2\n";
  for (const std::string first :
       {"G6.2 P3 K0 X0 Yq", "G6.2 G1 P3 K0 X0 Y0", "G41.1 D1 F60\nG6.2 P3 K0 X0 Y0"}) {
    const Program program = read_program("F60\n" + first + "\n" + rest);
    ASSERT_GE(program.diagnostics.size(), 2U) << first;
    const auto line = static_cast<std::uint32_t>(std::count(first.begin(), first.end(), '\n'));
    EXPECT_EQ(program.diagnostics[0].source.line, 2U + line) << first;
    EXPECT_EQ(program.diagnostics[1].source.line, 8U + line) << first;
  }
  const Program uniform =
      read_program("F60\nG5.2 P1 Xq L3\nX5 Y5 P1\nX10 Y0 P1\nG5.3\nG1 X5\nM2\n");
  EXPECT_EQ(uniform.diagnostics.size(), 1U);
}

TEST(Nurbs, LeavesRoomForOtherBlocksOnceItIsComplete) {
  const auto moves = moves_of("F60\nG6.2 P2 K0 X0 Y0\nK0 X1\nK1\nK1\nM8\nG4 P1\nG64\nG1 X2");
  ASSERT_EQ(moves.size(), 4U);
  EXPECT_EQ(std::get<EventMove>(moves[1].shape).kind, EventKind::flood_on);
}

}  // namespace
}  // namespace kerf::parser
