#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

using Lines = std::vector<std::string>;

// The moves of a Fanuc program, or its first error.
Lines run(const std::string& text, double least_increment_mm = 0.0) {
  ReaderOptions options;
  options.dialect = Dialect::fanuc;
  options.machine = default_program_data();
  options.machine.second_home_mm = {1, 2, 3};
  options.machine.further_homes[0].mm = {4, 5, 6};
  options.machine.further_homes[1].mm = {7, 8, 9};
  options.machine.least_increment_mm = least_increment_mm;
  const Program program = read_program(text + "\nM30\n", options);
  Lines lines;
  if (program.has_errors) {
    for (const diagnostics::Diagnostic& one : program.diagnostics) {
      if (one.severity == diagnostics::Severity::error) {
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

TEST(Fanuc, ReturnsToTheSecondToFourthReferencePoint) {
  EXPECT_EQ(run("G30 P2 X0 Y0"), (Lines{"1: rapid to 1 2 0"}));
  EXPECT_EQ(
      run("G30 X0 Y0\nG30 P3 X0 Z0\nG30 P4"),
      (Lines{"1: rapid to 1 2 0", "2: rapid to 0 2 0", "2: rapid to 4 2 6", "3: rapid to 7 8 9"}));
  EXPECT_EQ(run("G30 P5 X0").at(0), "p:1:5: error: G30: P must be 2, 3 or 4, found 5 [E0901]");
}

TEST(Fanuc, OfAMotionAndACycleInOneBlockTheLastOneCounts) {
  const std::string hole = " X1. Z-2. R1. F60";
  EXPECT_EQ(run("G0 Z5.\nG1 G81" + hole), run("G0 Z5.\nG81" + hole));
  EXPECT_EQ(run("G0 Z5.\nG81 G1 X1. F60"), (Lines{"1: rapid to 0 0 5", "2: line to 1 0 5 feed 1"}));
  EXPECT_EQ(run("G0 Z5.\nG81 G1" + hole).at(0),
            "p:2:17: error: R is not used in this block [E0150]");
}

TEST(Fanuc, G80ComesBackToTheMotionBeneathTheCycle) {
  const std::string hole = " X1. Z-2. R1. F60\n";
  EXPECT_EQ(run("G0 Z5.\nG1 G81" + hole + "G80\nX3.").back(), "4: line to 3 0 5 feed 1");
  EXPECT_EQ(run("G0 Z5.\nG81" + hole + "G83 X2. Q1.\nG80 X3.").back(), "4: rapid to 3 0 5");
  EXPECT_EQ(run("G1 X1. F60\nG80\nX3.").back(), "3: line to 3 0 0 feed 1")
      << "there is no cycle to end";
  EXPECT_EQ(run("G80 X3.").at(0),
            "p:1:5: error: axis words are given but no motion mode is active (G0, G1, G2 ... is "
            "expected) [E0145]");
}

TEST(Fanuc, RefusesWhatDependsOnTheControlsParameters) {
  EXPECT_EQ(run("S500 M3\nG87 X5. Y5. Z-5. R1. Q1. F100").at(0),
            "p:2:1: error: G87 with Fanuc's words (Q: the shift) is not supported [E0815]");
  EXPECT_EQ(run("G76 X5. Z-5. R1. Q1. F100").at(0),
            "p:1:1: error: G76 is not supported (fine boring: the way aside is a parameter of the "
            "control): write the moves out [E0103]");
  EXPECT_EQ(run("G41 D1 G1 X20. F60\nG42 X40.\nX60.").at(0),
            "p:2:1: error: G42 while G41 is active: a change of side is not supported, write G40 "
            "between them [E0748]");
}

TEST(Fanuc, RoundsInStatementsAndNotInAddresses) {
  EXPECT_EQ(run("#1=ROUND[2.6]\nG0 X#1\nG[ROUND[0.6]] X4. F60"),
            (Lines{"2: rapid to 3 0 0", "3: line to 4 0 0 feed 1"}));
  EXPECT_EQ(run("G0 X[1+ROUND[2.6]]").at(0),
            "p:1:8: error: ROUND in the value of X (Fanuc: to the least increment) is not "
            "supported: round in a statement before [E0908]");
}

TEST(Fanuc, G92SHoldsTheSpeedOfG96) {
  EXPECT_EQ(run("G92 S300\nG96 S100 M3").at(0), "2: spindle cw 300") << "at X0";
  EXPECT_EQ(run("G92 S300 X5.\nG96 S100 M3\nG97 S50\nG92 S10\nG96 S100").back(),
            "5: spindle cw 10");
}

TEST(Fanuc, LeavesOutTheBlocksWhoseSwitchIsOn) {
  const auto xs_with = [](BlockDelete switches) {
    ReaderOptions options;
    options.dialect = Dialect::fanuc;
    options.block_delete = switches;
    const Program program = read_program(
        "/G0 X1.\n/1 G0 X2.\n/2 G0 X3.\n /9G0X4.\nG0 X5.\n/2GOTO 7\nG0 X6.\nN7 G0 "
        "X7.\nM30\n",
        options);
    EXPECT_TRUE(program.diagnostics.empty());
    std::string xs;
    for (const Move& move : program.moves) {
      if (const auto* line = std::get_if<LineMove>(&move.shape)) {
        xs += text_of(line->end_mm).substr(0, 1);
      }
    }
    return xs;
  };
  BlockDelete first;
  first.switch_on(1);
  BlockDelete second_and_ninth;
  second_and_ninth.switch_on(2);
  second_and_ninth.switch_on(9);
  EXPECT_EQ(xs_with({}), "123457");
  EXPECT_EQ(xs_with(first), "3457");
  EXPECT_EQ(xs_with(second_and_ninth), "12567");
  EXPECT_EQ(xs_with(BlockDelete::all()), "567");
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

std::string warnings(const std::string& text, double least_increment_mm = 0.0) {
  ReaderOptions options;
  options.dialect = Dialect::fanuc;
  options.machine.least_increment_mm = least_increment_mm;
  std::string all;
  for (const diagnostics::Diagnostic& one : read_program(text + "\nM30\n", options).diagnostics) {
    all += to_string(one, "p") + "\n";
  }
  return all;
}

TEST(LeastIncrement, IsWarnedOfOnceWhereItIsNotInForce) {
  EXPECT_EQ(warnings("G0 X0 Y5 Z5\nG1 X0 Y-10 F100\nX20"),
            "p:2:7: warning: Y-10 without a decimal point is read as -10 mm [E0909]\n");
  EXPECT_EQ(warnings("G20 G1 X1. Y2. F10\nG81 X#1 Z1"), warnings("G20 G1 F10 X1.\nG81 Y#1 Z1"));
  EXPECT_EQ(warnings("G1 X1. Y[1+1] Z0 F100\nG2 X2. I.5"), "");
  EXPECT_EQ(warnings("G1 X1 F100", 0.001), "");
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
