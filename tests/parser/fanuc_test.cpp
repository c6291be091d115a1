#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

using Lines = std::vector<std::string>;

// The moves of a Fanuc program, or its first error.
Lines run(const std::string& text, double least_increment_mm = 0.0) {
  ReaderOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = default_machine_data();
  options.machine.second_home_mm = {1, 2, 3};
  options.machine.least_increment_mm = least_increment_mm;
  const Program program = read_program(text + "\nM30\n", options);
  Lines lines;
  if (program.has_errors) {
    for (const Diagnostic& one : program.diagnostics) {
      if (one.severity == Severity::error) {
        return {to_string(one, "p")};
      }
    }
  }
  for (const Move& move : program.moves) {
    lines.push_back(text_of(move));
  }
  lines.pop_back();
  return lines;
}

TEST(Fanuc, DwellsByMillisecondsInPAndSecondsInXOrU) {
  EXPECT_EQ(run("G04 P500\nG04 X1.5\nG04 U.25"),
            (Lines{"1: dwell 0.5", "2: dwell 1.5", "3: dwell 0.25"}));
}

TEST(Fanuc, DwellingMovesNothing) {
  EXPECT_EQ(run("G1 X5. F60\nG04 X2.\nX6."),
            (Lines{"1: line to 5 0 0 feed 1", "2: dwell 2", "3: line to 6 0 0 feed 1"}));
  EXPECT_EQ(run("G04 Z2."),
            (Lines{"p:1:5: error: G4 takes the time in P, X or U, not in Z [E0144]"}));
}

TEST(Fanuc, ReturnsToTheSecondReferencePoint) {
  EXPECT_EQ(run("G30 P2 X0 Y0"), (Lines{"1: rapid to 1 2 0"}));
  EXPECT_EQ(run("G30 P3 X0").at(0),
            "p:1:5: error: G30: P must be 2 (this machine has no other reference point), found 3 "
            "[E0901]");
}

TEST(Fanuc, AddsWearToTheGeometryOfAToolsLength) {
  EXPECT_EQ(run("G10 L10 P5 R20.\nG10 L11 P5 R.5\nG0 G43 H5 Z0"), (Lines{"3: rapid to 0 0 20.5"}));
  EXPECT_EQ(run("G10 L11 P5 R.5\nG10 L10 P5 R20.\nG0 G43 H5 Z0"), (Lines{"3: rapid to 0 0 20.5"}));
  EXPECT_EQ(run("G10 L10 P5 R20.\nG91 G10 L11 P5 R.5\nG10 L11 P5 R.25\nG90 G0 G43 H5 Z0"),
            (Lines{"4: rapid to 0 0 20.75"}));
}

TEST(Fanuc, SetsTheRadiusOfATool) {
  // On the left of a way along X, 5.5 mm off it.
  const Lines lines = run("G10 L12 P5 R5.\nG10 L13 P5 R.5\nG41 D5 G1 X20. F60\nX40.\nX60.");
  EXPECT_EQ(lines.at(0), "3: line to 20 5.5 0 feed 1");
}

TEST(Fanuc, TakesTheLevelOfContourControl) {
  EXPECT_EQ(run("G05.1 Q1 R5\nG1 X5. F60\nG05.1 Q0"), (Lines{"2: line to 5 0 0 feed 1"}));
}

TEST(Fanuc, EndsABlockAtASemicolonThatWordsFollow) {
  EXPECT_EQ(run("G1 X5. F60; Y7.; (a remark)"),
            (Lines{"1: line to 5 0 0 feed 1", "1: line to 5 7 0 feed 1"}));
  EXPECT_EQ(run("#1=5; G0 X#1; #1=6; Y#1;"), (Lines{"1: rapid to 5 0 0", "1: rapid to 5 6 0"}));
}

TEST(Fanuc, TakesWhatIsNoBlockBehindASemicolonForARemark) {
  EXPECT_EQ(run("G1 X5. F60; Y7 is next"), (Lines{"1: line to 5 0 0 feed 1"}));
  EXPECT_EQ(run("G1 X5. F60;"), (Lines{"1: line to 5 0 0 feed 1"}));
}

TEST(Fanuc, CountsColumnsBehindASemicolonFromTheStartOfTheLine) {
  EXPECT_EQ(run("G1 X5. F60; G999").at(0), "p:1:13: error: G999 is not known [E0100]");
}

TEST(LeastIncrement, IsTheUnitOfNumbersWithoutAPoint) {
  EXPECT_EQ(run("G1 X1000 Y2. F60", 0.001), (Lines{"1: line to 1 2 0 feed 1"}));
  EXPECT_EQ(run("G2 X1000 Y1000 I500 J500 F60", 0.001),
            (Lines{"1: clockwise in xy about 0.5 0.5 0 to 1 1 0 turns 1 feed 1"}));
}

TEST(LeastIncrement, IsATenthOfThatInInches) {
  EXPECT_EQ(run("G20\nG1 X10000 F60", 0.001), (Lines{"2: line to 25.4 0 0 feed 25.4"}));
}

TEST(LeastIncrement, DoesNotCountRepeatsModesAndTimes) {
  EXPECT_EQ(run("G0 Z5000\nG91 G81 X1000 Z-2000 R-4000 K2 F60", 0.001).size(), 9U);
  EXPECT_EQ(run("G04 X1500\nG04 P1500", 0.001), (Lines{"1: dwell 1.5", "2: dwell 1.5"}));
  EXPECT_EQ(run("G05.1 Q1", 0.001), (Lines{}));
  EXPECT_EQ(run("G51 X0 Y0 P2000\nG0 X1000", 0.001), (Lines{"2: rapid to 2 0 0"}));
}

TEST(LeastIncrement, LeavesExpressionsAlone) {
  EXPECT_EQ(run("#1=5\nG0 X#1 Y[2+1]", 0.001), (Lines{"2: rapid to 5 3 0"}));
}

TEST(LeastIncrement, IsOfTheFanucDialectOnly) {
  ReaderOptions options;
  options.machine.least_increment_mm = 0.001;
  EXPECT_EQ(text_of(read_program("G0 X5\nM2\n", options).moves.at(0)), "1: rapid to 5 0 0");
}

}  // namespace
}  // namespace kerf::parser
