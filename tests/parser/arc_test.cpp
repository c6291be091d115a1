#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "parser/moves/arc_geometry.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

constexpr double kPi = 3.14159265358979323846;

std::string number(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(12);
  out << std::fixed << value;
  return out.str();
}

// The angle swept by an arc in the XY plane, 0 to 2 pi, from its centre and direction alone.
double swept(const ArcMove& arc, const Point& start) {
  const double from = std::atan2(start[1] - arc.centre_mm[1], start[0] - arc.centre_mm[0]);
  const double to = std::atan2(arc.end_mm[1] - arc.centre_mm[1], arc.end_mm[0] - arc.centre_mm[0]);
  const double angle = std::fmod((arc.clockwise ? from - to : to - from) + 4 * kPi, 2 * kPi);
  return angle;
}

TEST(Arc, GivenByRadiusIsRefusedWhereItsEndIsItsStartButForRounding) {
  for (const char* const end : {"X0.3", "X[0.1+0.2]", "X[0.3+1/10**17]", "X[0.3+1/10**12]",
                                "X0.3 Y[1/10**11]", "X0.3 Y[1/10**200]"}) {
    for (const char* const how : {"G2 R5 ", "G3 R5 ", "G2 R-5 ", "G3 R-5 "}) {
      const std::string text = std::string("F600 G1 X0.3\n") + how + end + "\n";
      EXPECT_NE(first_message(text).find("cannot be a full circle"), std::string::npos) << text;
    }
  }
}

TEST(Arc, GivenByRadiusTakesTheShortWayAndWithANegativeRadiusTheLongOne) {
  constexpr unsigned kSeed = 11;
  std::mt19937 random(kSeed);
  std::uniform_real_distribution<double> place(-50.0, 50.0);
  std::uniform_real_distribution<double> excess(1.001, 5.0);
  for (int i = 0; i < 500; ++i) {
    const double x = place(random);
    const double y = place(random);
    const double radius = std::hypot(x, y) / 2 * excess(random);
    for (const char* const code : {"G2", "G3"}) {
      for (const char* const sign : {"", "-"}) {
        const std::string text = std::string("F60 ") + code + " X" + number(x) + " Y" + number(y) +
                                 " R" + sign + number(radius);
        const auto moves = moves_of(text);
        const auto& arc = std::get<ArcMove>(moves.at(0).shape);
        const double at_start = std::hypot(arc.centre_mm[0], arc.centre_mm[1]);
        const double at_end = std::hypot(arc.centre_mm[0] - x, arc.centre_mm[1] - y);
        ASSERT_NEAR(at_start, radius, 1e-9 * radius) << text << " seed " << kSeed;
        ASSERT_NEAR(at_end, radius, 1e-9 * radius) << text;
        ASSERT_EQ(arc.clockwise, code[1] == '2');
        ASSERT_EQ(swept(arc, {0, 0, 0}) > kPi, *sign == '-') << text;
      }
    }
  }
}

TEST(Arc, WithARadiusOfHalfTheChordIsAHalfCircleThoughRounded) {
  const auto moves = moves_of("F60 G2 X10 R4.995");
  const auto& arc = std::get<ArcMove>(moves.at(0).shape);
  EXPECT_NEAR(arc.centre_mm[0], 5.0, 1e-12);
  EXPECT_NEAR(arc.centre_mm[1], 0.0, 1e-12);
  EXPECT_NE(first_message("F60 G2 X10 R4.98"), "no message");
}

TEST(Arc, ToleratesWhatLinuxCncTolerates) {
  EXPECT_EQ(first_message("F60 G3 X10.028 I5"), "no message") << "0.028 mm";
  EXPECT_NE(first_message("F60 G3 X10.03 I5"), "no message") << "0.03 mm are 0.6 %";
  EXPECT_EQ(first_message("F60 G3 X2001 I1000"), "no message") << "1 mm is 0.1 %";
  EXPECT_NE(first_message("F60 G3 X2002 I1000"), "no message") << "0.2 %";
  EXPECT_NE(first_message("F60 G3 X200003 I100000"), "no message") << "never more than 2.83 mm";
}

TEST(Arc, WithoutAnEndIsAFullCircle) {
  const auto moves = moves_of("F60 G2 I5 J5\nG2 X0 Y0 I5 J5\nG2 X0 Y0 Z3 I5 P3");
  for (const Move& move : moves) {
    const auto& arc = std::get<ArcMove>(move.shape);
    EXPECT_EQ(arc.end_mm[0], 0.0);
    EXPECT_EQ(arc.end_mm[1], 0.0);
  }
  EXPECT_EQ(std::get<ArcMove>(moves[2].shape).turns, 3);
}

// Length by adding up chords of the curve drawn from its definition.
TEST(Arc, LengthAgreesWithItsChords) {
  const Point start{3, 0, 0};
  const ArcMove arc{Plane::xy, {0, 0, 0}, {0, 3, 7}, true, 2};
  const double angle = 1.5 * kPi + 2 * kPi;
  double length = 0.0;
  Point before = start;
  constexpr int kChords = 200'000;
  for (int i = 1; i <= kChords; ++i) {
    const double part = static_cast<double>(i) / kChords;
    const Point here{3 * std::cos(-angle * part), 3 * std::sin(-angle * part), 7 * part};
    length += std::hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
    before = here;
  }
  EXPECT_NEAR(before[0], arc.end_mm[0], 1e-9);
  EXPECT_NEAR(before[1], arc.end_mm[1], 1e-9);
  EXPECT_NEAR(arc_length_mm(arc, start), length, 1e-6);
}

TEST(Arc, InInchesIsTheSameArc) {
  const auto mm = moves_of("F60 G2 X25.4 Y25.4 I25.4");
  const auto inch = moves_of("F60 G20 G2 X1 Y1 I1");
  EXPECT_EQ(text_of(mm.at(0)).substr(0, 60), text_of(inch.at(0)).substr(0, 60));
}

}  // namespace
}  // namespace kerf::parser
