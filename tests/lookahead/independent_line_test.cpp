// Lines that need no cells.
#include "lookahead/optimum/grid/independent_line.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

Block line_of(double length_mm, double feedrate_mm_s = 100.0) {
  return blocks_of({line_move({{0, 0, 0}, {length_mm, 0, 0}}, feedrate_mm_s)}, mill()).front();
}

const Junction kRest{.feedrate_mm_s = 0.0};
const Junction kCorner{.feedrate_mm_s = 1.0, .constant_velocity_s = 3.0 * kTs};

TEST(IndependentLine, IsAnyLineFromRestToRest) {
  for (const double length_mm : {1e-6, 0.1, 100.0}) {
    EXPECT_TRUE(is_independent_line(line_of(length_mm), {.begin = kRest, .end = kRest}));
  }
}

// Up to 1.2 mm/s and down again takes two transitions of 0.2 mm/s, each of 2 sqrt(0.2 / J) at a
// mean of 1.1 mm/s, and the corners take three ticks each.
TEST(IndependentLine, HasRoomToBeFasterThanItsCorners) {
  const double way_mm = 2.0 * (1.1 * 2.0 * std::sqrt(0.2 / 5e4) + 1.0 * 3.0 * kTs);
  EXPECT_TRUE(is_independent_line(line_of(1.001 * way_mm), {.begin = kCorner, .end = kCorner}));
  EXPECT_FALSE(is_independent_line(line_of(0.999 * way_mm), {.begin = kCorner, .end = kCorner}));
}

// From 1 to 1.5 mm/s in a transition of 2 sqrt(0.5 / J) at a mean of 1.25 mm/s.
TEST(IndependentLine, IsAsLongAsItTakesFromOneCruiseToAnother) {
  const Junction faster{.feedrate_mm_s = 1.5, .constant_velocity_s = 3.0 * kTs};
  const double way_mm = 1.25 * 2.0 * std::sqrt(0.5 / 5e4) + (1.0 + 1.5) * 3.0 * kTs;
  LineJunctions junctions{.begin = kCorner, .end = faster};
  EXPECT_FALSE(is_independent_line(line_of(1.001 * way_mm), junctions));
  junctions.are_cruises = true;
  EXPECT_TRUE(is_independent_line(line_of(1.001 * way_mm), junctions));
  EXPECT_FALSE(is_independent_line(line_of(0.999 * way_mm), junctions));
}

TEST(IndependentLine, MayRunThroughAtItsFeedrate) {
  const Junction through{.feedrate_mm_s = 100.0};
  EXPECT_TRUE(is_independent_line(line_of(0.01), {.begin = through, .end = through}));
  EXPECT_FALSE(is_independent_line(line_of(0.01), {.begin = kRest, .end = through}));
}

TEST(IndependentLine, IsNoArc) {
  const auto arc =
      blocks_of({arc_move({.ends = {{0, 0, 0}, {10, 10, 0}}, .centre = {0, 10, 0}}, 10.0)}, mill());
  EXPECT_FALSE(is_independent_line(arc.front(), {.begin = kRest, .end = kRest}));
}

// The feedrate from which the S-curve comes to rest over so many lines, without acceleration at the
// ends of each.
double brakes_from_mm_s(int count, double length_mm) {
  const profiles::Profile s_curve(profiles::ProfileKind::s_curve);
  const profiles::RampLimits ramp = line_of(length_mm).limits.ramp;
  double v = 0.0;
  for (int i = 0; i < count; ++i) {
    double low = v;
    double high = v + 200.0;
    for (int step = 0; step < 60; ++step) {
      const double middle = 0.5 * (low + high);
      (s_curve.length_mm({middle, v}, ramp) < length_mm ? low : high) = middle;
    }
    v = low;
  }
  return v;
}

TEST(LinesAhead, AreLongEnoughWhereTheSCurveBrakesLineByLine) {
  constexpr int kLines = 200;
  for (const double length_mm : {0.005, 0.02, 0.1, 0.5}) {
    const double v = brakes_from_mm_s(kLines, length_mm);
    for (const double share : {0.9, 1.1}) {
      LinesAhead lines(kLines);
      for (int i = 0; i < kLines; ++i) {
        EXPECT_TRUE(lines.are_long_enough()) << "there are fewer";
        lines.push(line_of(length_mm), share * v);
      }
      EXPECT_EQ(lines.are_long_enough(), share < 1.0) << length_mm << " mm from " << v << " mm/s";
    }
  }
}

TEST(LinesAhead, AreTheLastOnes) {
  LinesAhead lines(10);
  lines.push(line_of(100.0), 100.0);
  for (int i = 0; i < 9; ++i) {
    lines.push(line_of(0.02), 100.0);
  }
  EXPECT_TRUE(lines.are_long_enough()) << "on the first";
  lines.push(line_of(0.02), 100.0);
  EXPECT_FALSE(lines.are_long_enough());
  lines.clear();
  EXPECT_TRUE(lines.are_long_enough());
}

}  // namespace
}  // namespace kerf::lookahead::test
