#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

// What follows the positioning, without line numbers.
std::vector<std::string> steps_of(const std::string& text) {
  std::vector<std::string> steps;
  for (const Move& move : moves_of(text)) {
    const std::string step = text_of(move);
    steps.push_back(step.substr(step.find(' ') + 1));
  }
  return steps;
}

using Steps = std::vector<std::string>;

TEST(Cycles, TappingTurnsTheSpindleRoundAtTheBottomAndBackAtTheTop) {
  EXPECT_EQ(steps_of("F60 S500 M3 G84 Z-3 R0 P0.5"),
            (Steps{"spindle cw 500", "speed override 0", "line to 0 0 -3 feed 1", "spindle off 0",
                   "spindle ccw 500", "dwell 0.5", "line to 0 0 0 feed 1", "spindle off 0",
                   "spindle cw 500", "speed override 1"}));
}

TEST(Cycles, LeftHandTappingDoesSoTheOtherWay) {
  EXPECT_EQ(steps_of("F60 S500 M4 G74 Z-3 R0"),
            (Steps{"spindle ccw 500", "speed override 0", "line to 0 0 -3 feed 1", "spindle off 0",
                   "spindle cw 500", "line to 0 0 0 feed 1", "spindle off 0", "spindle ccw 500",
                   "speed override 1"}));
}

TEST(Cycles, BoringLeavesTheHoleWithTheSpindleStopped) {
  EXPECT_EQ(steps_of("F60 S500 M4 G86 Z-3 R0 P1"),
            (Steps{"spindle ccw 500", "line to 0 0 -3 feed 1", "dwell 1", "spindle off 0",
                   "rapid to 0 0 0", "spindle ccw 500"}));
}

TEST(Cycles, BoringByHandStopsTheProgramBeforeTheToolLeaves) {
  EXPECT_EQ(steps_of("F60 S500 M3 G88 Z-3 R0 P1"),
            (Steps{"spindle cw 500", "line to 0 0 -3 feed 1", "dwell 1", "spindle off 0",
                   "program stop 0", "rapid to 0 0 0", "spindle cw 500"}));
}

TEST(Cycles, BackBoringPassesTheHoleAsideWithTheSpindleOriented) {
  const Steps steps = steps_of("F60 S500 M3 G87 Z-3 R1 I2 J0 K-1");
  EXPECT_EQ(steps,
            (Steps{"spindle cw 500", "rapid to 0 0 1", "rapid to 2 0 1", "spindle off 0",
                   "orient 0", "rapid to 2 0 -3", "rapid to 0 0 -3", "spindle cw 500",
                   "line to 0 0 -1 feed 1", "line to 0 0 -3 feed 1", "spindle off 0", "orient 0",
                   "rapid to 2 0 -3", "rapid to 2 0 1", "rapid to 0 0 1", "spindle cw 500"}));
}

TEST(Cycles, RunOnTheExactPathWhileCornersAreBlended) {
  for (const Move& move : moves_of("G64 P0.1 F60 G81 X1 Z-3 R1\nX2 Y3")) {
    EXPECT_EQ(move.mode, PathMode::exact_path) << text_of(move);
    EXPECT_EQ(move.blend_tolerance_mm, 0.0) << text_of(move);
    EXPECT_EQ(move.merge_tolerance_mm, 0.0) << text_of(move);
  }
  EXPECT_EQ(moves_of("G64 P0.1 F60 G81 X1 Z-3 R1\nG1 X2").back().mode, PathMode::blend);
}

TEST(Cycles, KeepTheExactStop) {
  for (const Move& move : moves_of("G61.1 F60 G81 X1 Z-3 R1\nX2 Y3")) {
    EXPECT_EQ(move.mode, PathMode::exact_stop) << text_of(move);
  }
}

TEST(Cycles, DoNothingInABlockWithoutAnAxisWord) {
  EXPECT_EQ(steps_of("F60 G81 X1 Z-3 R1\nF120\nS100\nG99").size(), 4U);
  EXPECT_EQ(first_message("F60 G81 X1 Z-3 R1\nR2"), "2:1: error: G81 needs at least one axis word");
}

TEST(Cycles, WantTheirWordsAgainAfterAnotherCycle) {
  EXPECT_EQ(first_message("F60 G81 X1 Z-3 R1\nG82 X2 P1"), "2:1: error: G82 needs R");
  EXPECT_EQ(first_message("F60 G81 X1 Z-3 R1\nG0 X1\nG81 X2"), "3:1: error: G81 needs R");
}

TEST(Cycles, NameTheWordOfTheDrillingAxis) {
  EXPECT_EQ(first_message("F60 G18 G81 X1 Z-3 R1"), "1:9: error: G81 needs Y");
  EXPECT_EQ(first_message("F60 G19 G81 Y1 Z-3 R1"), "1:9: error: G81 needs X");
}

TEST(Cycles, SayOneMistakeOnce) {
  const Program program = read_program("F60\nG81 X1 Z-3\nX2\nX3\nG83 X4 Z-3 R1 Q0\nX5\nM2\n");
  EXPECT_EQ(program.diagnostics.size(), 2U);
}

TEST(Cycles, SayTheLevelsInTheUnitsOfTheProgram) {
  EXPECT_EQ(first_message("G20 F10\nG81 X1 Z-.5 R-1"),
            "2:8: error: G81: R (-1.000) is below Z (-0.500)");
}

TEST(Cycles, DoNotPeckTwiceAtADepthReachedButForRounding) {
  int feeds = 0;
  for (const Move& move : moves_of("F60 G83 Z-3 R2 Q0.1")) {
    feeds += std::holds_alternative<LineMove>(move.shape) && !move.rapid ? 1 : 0;
  }
  EXPECT_EQ(feeds, 50);
}

TEST(Cycles, OfFanucBeginAtTheInitialLevelAndRepeatByK) {
  const Program program =
      read_program("G0 Z10\nG91 G81 X5 Z-3 R-8 K2 F60\nM2\n", {.dialect = Dialect::fanuc});
  ASSERT_FALSE(program.has_errors) << to_string(program.diagnostics.front(), "");
  ASSERT_EQ(program.moves.size(), 10U);
  EXPECT_EQ(text_of(program.moves[4]), "2: rapid to 5 0 10");
  EXPECT_EQ(text_of(program.moves[7]), "2: line to 10 0 -1 feed 1");
}

// A row of holes as programs for these controls have it: the first with G90, the others by G91 K.
TEST(Cycles, OfFanucKeepTheLevelsOfTheModeThatTheyWereGivenIn) {
  const auto bottom_of = [](const std::string& row) {
    const Program program = read_program(row + "\nM2\n", {.dialect = Dialect::fanuc});
    EXPECT_FALSE(program.has_errors) << to_string(program.diagnostics.front(), "");
    return text_of(program.moves.at(program.moves.size() - 3));
  };
  const std::string first = "G0 Z10\nG90 G99 G81 X0 Z-3 R2 F60\n";
  EXPECT_EQ(bottom_of(first + "G91 X5 K2"), "3: line to 10 0 -3 feed 1");
  EXPECT_EQ(bottom_of(first + "G91 X5 Z-4"), "3: line to 5 0 -2 feed 1") << "from R";
  EXPECT_EQ(bottom_of("G0 Z10\nG91 G99 G81 X5 Z-3 R-8 F60\nG90 X7"), "3: line to 7 0 -1 feed 1");
}

TEST(Cycles, OfFanucTakeTheDwellInMilliseconds) {
  const Program program = read_program("G82 X5 Z-3 R1 P250 F60\nM2\n", {.dialect = Dialect::fanuc});
  ASSERT_FALSE(program.has_errors);
  EXPECT_EQ(text_of(program.moves[3]), "1: dwell 0.25");
}

TEST(Cycles, OfFanucStoreTheirWordsWithK0) {
  const Program program =
      read_program("G81 X5 Z-3 R1 K0 F60\nX6\nM2\n", {.dialect = Dialect::fanuc});
  ASSERT_FALSE(program.has_errors);
  EXPECT_EQ(text_of(program.moves[1]), "2: rapid to 6 0 1");
}

TEST(Cycles, FanucPecksMayDwellAtTheBottom) {
  const Program program =
      read_program("G0 Z5\nG83 X5 Z-3 R1 Q5 P500 F60\nM2\n", {.dialect = Dialect::fanuc});
  ASSERT_FALSE(program.has_errors);
  EXPECT_TRUE(std::any_of(program.moves.begin(), program.moves.end(),
                          [](const Move& move) { return text_of(move) == "2: dwell 0.5"; }));
}

}  // namespace
}  // namespace kerf::parser
