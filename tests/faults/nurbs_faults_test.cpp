// Rows 31 to 44 of the table of faults: curves with control points. README.md lists them.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "curves/nurbs_curve.hpp"
#include "interp/setpoint.hpp"
#include "parser/curves/curve_block.hpp"
#include "tests/faults/checked.hpp"

namespace kerf::faults {
namespace {

// Of order 3 with knots 0 0 0 1 1 1 unless something else is written; blocks as lines.
std::string curve(const std::string& second, const std::string& third, const std::string& tail) {
  return "F600\nG6.2 P3 K0 X0 Y0\n" + second + "\n" + third + "\n" + tail + "M2\n";
}
const std::string kTail = "K1\nK1\nK1\n";

// The largest velocity of a run on the default machine, or an error.
struct Motion {
  double fastest_mm_s = 0.0;
  bool finite = true;
  curves::Position end_mm{};
  std::string error;
};
Motion run(const std::string& text) {
  Kernel kernel(default_machine());
  kernel.feed(text);
  kernel.finish();
  Motion result;
  interp::Setpoint setpoint;
  for (auto status = interp::TickStatus::running; status == interp::TickStatus::running;) {
    status = kernel.next(setpoint);
    const auto& v = setpoint.velocity_mm_s;
    const double speed = std::hypot(v[0], v[1], v[2]);
    result.finite = result.finite && std::isfinite(speed) && std::isfinite(setpoint.position_mm[0]);
    result.fastest_mm_s = std::max(result.fastest_mm_s, speed);
    result.end_mm = setpoint.position_mm;
  }
  result.error = kernel.has_errors() ? kernel.diagnostics().front().message : "";
  return result;
}

TEST(NurbsFaults, Row31FewerPointsThanTheOrderAreRefusedWithTheFirstLine) {
  EXPECT_EQ(said_of("F600\nG6.2 P3 K0 X0 Y0\nK0 X1 Y1\nK1\nM2\n"),
            "4:1: error: G6.2: order 3 needs at least 3 control points, found 2; the curve begins "
            "in line 2 [E0326]\n");
  EXPECT_TRUE(says(said_of("F600\nG5.2 X1 Y1 L4\nX2 Y2\nG5.3\nM2\n"),
                   "found 3; the curve begins in line 2"));
}

TEST(NurbsFaults, Row32AWrongCountOfKnotsIsRefusedWithBothNumbers) {
  EXPECT_TRUE(says(said_of(curve("K0 X1 Y1", "K0 X2 Y0", "K1\nK1\n")),
                   "3 knot-only blocks are needed at its end, found 2; the curve begins in "
                   "line 2"));
  EXPECT_TRUE(check(curve("K0 X1 Y1", "K0 X2 Y0", "K1\nK1\nK1\nK1\n")).has_errors());
}

TEST(NurbsFaults, Row33KnotsThatGoDownOrAreNoNumbersAreRefused) {
  EXPECT_TRUE(says(said_of(curve("K0 X1 Y1", "K0 X2 Y0", "K1\nK0.5\nK1\n")),
                   "6:1: error: G6.2: knot 0.5 is smaller than the knot before it (1); the "
                   "curve begins in line 2"));
  EXPECT_TRUE(check(curve("K0 X1 Y1", "Knan X2 Y0", kTail)).has_errors());
}

TEST(NurbsFaults, Row34AnInnerKnotMayBeThereOnceLessThanTheOrder) {
  const auto with_inner = [](const std::string& knots) {
    return "F600\nG6.2 P3 K0 X0 Y0\nK0 X1 Y1\nK0 X2 Y0\n" + knots + "K2\nK2\nK2\nM2\n";
  };
  EXPECT_EQ(said_of(with_inner("K1 X3 Y3\nK1 X4 Y0\n")), "");
  EXPECT_TRUE(run(with_inner("K1 X3 Y3\nK1 X4 Y0\n")).error.empty()) << "a corner inside";
  EXPECT_TRUE(says(said_of(with_inner("K1 X3 Y3\nK1 X4 Y0\nK1 X5 Y0\n")), "[E0325]"));
  EXPECT_TRUE(says(said_of(with_inner("K1 X3 Y3\nK1 X4 Y0\nK1 X5 Y0\nK1 X6 Y0\n")), "[E0325]"));
}

TEST(NurbsFaults, Row35EqualKnotsAreNoRange) {
  EXPECT_TRUE(says(said_of(curve("K0 X1 Y1", "K0 X2 Y0", "K0\nK0\nK0\n")), "[E0327]"));
}

TEST(NurbsFaults, Row36WeightsAreAboveZeroEverywhereAndNotFarApart) {
  for (const char* const weight : {"R0", "R-1", "R-0.5"}) {
    EXPECT_TRUE(says(said_of(curve(std::string("K0 X1 Y1 ") + weight, "K0 X2 Y0", kTail)), "3:"))
        << weight;
    const std::string first = "F600\nG6.2 P3 K0 X0 Y0 " + std::string(weight) + "\nM2\n";
    EXPECT_TRUE(says(said_of(first), "2:")) << weight;
    EXPECT_TRUE(check(first).has_errors()) << weight;
  }
  EXPECT_TRUE(check("F600\nG5.2 X1 Y1 P-1 L3\nX2 Y2 P1\nG5.3\nM2\n").has_errors());
  const std::string tiny = curve("K0 X1 Y1 R0." + std::string(300, '0') + "1", "K0 X2 Y0", kTail);
  EXPECT_TRUE(says(said_of(tiny), "[E0302]"));
  EXPECT_TRUE(run(tiny).finite);
  EXPECT_TRUE(check(curve("K0 X1 Y1 R1" + std::string(300, '0'), "K0 X2 Y0", kTail)).has_errors())
      << "1e300";
  EXPECT_TRUE(says(said_of(curve("K0 X1 Y1 R1000001", "K0 X2 Y0", kTail)), "[E0302]"));
  EXPECT_EQ(said_of(curve("K0 X1 Y1 R1000", "K0 X2 Y0", kTail)), "");
}

TEST(NurbsFaults, Row37ACurveOfNoLengthIsLeftOutWithAWarning) {
  const std::string text = curve("K0 X0 Y0", "K0 X0 Y0", kTail);
  EXPECT_TRUE(says(said_of(text), "zero length and is left out [E0301]"));
  EXPECT_FALSE(check(text).has_errors());
  EXPECT_FALSE(check(text).moves);
  EXPECT_EQ(said_of(curve("K0 X2 Y2", "K0 X2 Y2", kTail)), "") << "two points are one";
}

TEST(NurbsFaults, Row38ACuspIsPassedWithinTheLimits) {
  // A cubic whose handles cross: its derivative is zero in the middle.
  const std::string cusp =
      "F6000\nG6.2 P4 K0 X0 Y0\nK0 X10 Y10\nK0 X0 Y10\nK0 X10 Y0\nK1\nK1\nK1\nK1\nM2\n";
  const Motion found = run(cusp);
  EXPECT_EQ(found.error, "");
  EXPECT_TRUE(found.finite);
  EXPECT_GT(found.fastest_mm_s, 1.0);
  EXPECT_LE(found.fastest_mm_s, 100.0 * (1.0 + 1e-6));
  EXPECT_EQ(found.end_mm[0], 10.0);
}

TEST(NurbsFaults, Row39LoopsAreRunAndOneThatATolerancePassesOverIsAWarning) {
  const std::string closed =
      "F600\nG6.2 P4 K0 X0 Y0\nK0 X30 Y20\nK0 X-20 Y20\nK0 X0 Y0\nK1\nK1\nK1\nK1\nM2\n";
  EXPECT_EQ(said_of(closed), "");
  EXPECT_EQ(run(closed).error, "");
  const auto loop = [](const std::string& tolerance) {
    return "F600 " + tolerance + "\nG1 X10\nX10.1\nY0.1\nX10\nY0\nX20\nM2\n";
  };
  EXPECT_EQ(said_of(loop("G64 P1")),
            "3:1: warning: G64: a closed loop begins here that is nowhere larger than the "
            "tolerance (1 mm): it may vanish [E1011]\n");
  EXPECT_EQ(said_of(loop("G64 P0.02")), "");
  std::string many;
  for (int i = 0; i < 100; ++i) {
    many += "G0 X0\n" + loop(i % 2 == 0 ? "G64 P1" : "G64 P" + std::to_string(i));
    many.resize(many.size() - 3);  // without M2
  }
  EXPECT_EQ(check(many + "M2\n").diagnostics.size(), 20U);
  EXPECT_EQ(said_of(loop("G64 P1 Q0")), "") << "nothing is merged";
  EXPECT_EQ(said_of(loop("G61")), "");
  EXPECT_TRUE(says(said_of("F600 G64 P1000\nG1 X10\nY10\nX5\nM2\n"),
                   "2:1: warning: G64: the 3 lines from here on lie within 10 mm"));
}

TEST(NurbsFaults, Row40OrderTwoIsAPolylineAndOrderTwentyRefused) {
  const std::string lines = "F600\nG6.2 P2 K0 X0 Y0\nK0 X10 Y0\nK1 X10 Y10\nK2\nK2\nM2\n";
  EXPECT_EQ(said_of(lines), "");
  const CheckReport report = check(lines);
  EXPECT_EQ(report.extents.max_mm[0], 10.0);
  EXPECT_EQ(report.extents.max_mm[1], 10.0) << "through the control point, which is a corner";
  EXPECT_TRUE(says(said_of("F600\nG6.2 P20 K0 X0 Y0\nM2\n"), "P (order) must be 2 to 10"));
}

TEST(NurbsFaults, Row41TheFirstPointIsWhereTheToolIs) {
  EXPECT_TRUE(says(said_of("F600\nG6.2 P3 K0 X0.01 Y0\nK0 X1 Y1\nK0 X2 Y0\n" + kTail + "M2\n"),
                   "is not the current position (0.000 0.000 0.000)"));
}

TEST(NurbsFaults, Row42ACurveThatIsNotClosedIsRefused) {
  const std::string open = "F600\nG6.2 P3 K0 X0 Y0\nK0 X1 Y1\nK0 X2 Y0\nK1\n";
  EXPECT_TRUE(says(said_of(open + "G1 X5\nM2\n"), "; the curve begins in line 2 [E0328]"));
  EXPECT_TRUE(says(said_of(open + "M2\n"), "[E0328]"));
  EXPECT_TRUE(says(said_of(open), "[E0328]"));
  EXPECT_TRUE(says(said_of("F600\nG5.2 X1 Y1 L3\nX2 Y2\nG1 X5\nG5.3\nM2\n"),
                   "is not allowed before G5.3; the curve begins in line 2"));
}

TEST(NurbsFaults, Row43ACurveOfVeryManyPointsIsRefusedWithTheBound) {
  std::string text = "F600\nG6.2 P3 K0 X0 Y0\n";
  for (std::size_t i = 1; i <= parser::kMaxControlPoints; ++i) {
    text += "K" + std::to_string(i < 3 ? 0 : i - 2) + " X" + std::to_string(i % 100) + " Y0\n";
  }
  EXPECT_TRUE(says(said_of(text), "more than " + std::to_string(parser::kMaxControlPoints) +
                                      " control points; the curve begins in line 2"));
}

// The speed |B'| of a cubic that begins with a handle of 1e-5 mm, by its control points.
double speed_at(const std::array<std::array<double, 2>, 4>& p, double u) {
  double squares = 0.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const double d = 3.0 * ((1 - u) * (1 - u) * (p[1][k] - p[0][k]) +
                            2.0 * u * (1 - u) * (p[2][k] - p[1][k]) + u * u * (p[3][k] - p[2][k]));
    squares += d * d;
  }
  return std::sqrt(squares);
}

// By Simpson's rule on ever smaller intervals until two agree.
double arc_length(const std::array<std::array<double, 2>, 4>& p, double a, double b, int depth) {
  const auto simpson = [&p](double from, double to) {
    return (to - from) / 6.0 *
           (speed_at(p, from) + 4.0 * speed_at(p, 0.5 * (from + to)) + speed_at(p, to));
  };
  const double middle = 0.5 * (a + b);
  const double whole = simpson(a, b);
  const double halves = simpson(a, middle) + simpson(middle, b);
  if (depth == 0 || std::fabs(whole - halves) < 1e-14 * (1.0 + halves)) {
    return halves;
  }
  return arc_length(p, a, middle, depth - 1) + arc_length(p, middle, b, depth - 1);
}

TEST(NurbsFaults, Row44TheLengthOfANearlyDegenerateCurveIsExact) {
  const std::array<std::array<double, 2>, 4> p{{{0, 0}, {1e-5, 0}, {5, 10}, {15, 0}}};
  curves::NurbsData data{.degree = 3, .points = {}, .knots = {0, 0, 0, 0, 1, 1, 1, 1}};
  for (const auto& point : p) {
    data.points.push_back({.position_mm = {point[0], point[1], 0.0}, .weight = 1.0});
  }
  const auto made = curves::NurbsCurve::make(data);
  ASSERT_TRUE(made);
  double length_mm = 0.0;
  for (const curves::NurbsCurve& one : *made) {
    length_mm += one.length_mm();
  }
  const double wanted = arc_length(p, 0.0, 1.0, 40);
  EXPECT_NEAR(length_mm, wanted, 1e-9 * wanted);
}

}  // namespace
}  // namespace kerf::faults
