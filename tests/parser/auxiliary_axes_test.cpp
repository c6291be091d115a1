// A, B, C, U, V, W where the machine names them. Numbers of A, B and C are those of `rs274 -g`,
// LinuxCNC 2.9, where a test says so; U, V, W, which the stand-alone interpreter does not read,
// follow its manual.
#include <gtest/gtest.h>

#include "parser/modal/machine_data.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

ReaderOptions with_axes(Letters axes, Dialect dialect = Dialect::rs274) {
  ReaderOptions options{.dialect = dialect, .machine = default_program_data()};
  options.machine.extra_axes = axes;
  return options;
}

std::vector<Move> moves_with(Letters axes, std::string_view text,
                             Dialect dialect = Dialect::rs274) {
  Program program = read_program(std::string(text) + "\nM2\n", with_axes(axes, dialect));
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    ADD_FAILURE() << message_line(diagnostic, "program");
  }
  program.moves.pop_back();  // the end
  return program.moves;
}

std::string first_message_with(Letters axes, std::string_view text) {
  const Program program = read_program(std::string(text) + "\nM2\n", with_axes(axes));
  return program.diagnostics.empty() ? "no message"
                                     : message_line(program.diagnostics.front(), "").substr(1);
}

// Where each move leaves an axis, in degrees or mm.
std::vector<double> ends_of(const std::vector<Move>& moves, char letter) {
  const std::size_t axis = kAuxiliaryNames.find(letter);
  std::vector<double> ends;
  for (const Move& move : moves) {
    ends.push_back(
        std::round(move.auxiliary.end_rad_mm[axis] / (is_rotary(axis) ? kDegree : 1.0) * 1e4) /
        1e4);
  }
  return ends;
}

using AxisEnds = std::vector<double>;
constexpr Letters kA = letters('A');
constexpr Letters kU = letters('U');
constexpr Letters kAll = kAuxiliaryLetters;

TEST(ExtraAxes, AreRefusedAsBeforeWhereTheMachineDoesNotNameThem) {
  EXPECT_EQ(first_message_with(0, "G0 X10 A90"),
            "1:8: error: axis A does not exist on this machine");
  EXPECT_EQ(first_message_with(kA, "G0 A1 B90"),
            "1:7: error: axis B does not exist on this machine");
  EXPECT_EQ(first_message_with(kA, "G0 U1"), "1:4: error: axis U does not exist on this machine");
}

// rs274: A90, then X10 A180, X10 A0 B5 C7, A10.
TEST(ExtraAxes, MoveAbsoluteAndIncremental) {
  const auto moves =
      moves_with(letters('A', 'B', 'C'), "G1 A90 F360\nG1 X10 A180 F100\nG0 A0 B5 C7\nG91 G1 A10");
  EXPECT_EQ(ends_of(moves, 'A'), (AxisEnds{90, 180, 0, 10}));
  EXPECT_EQ(ends_of(moves, 'B'), (AxisEnds{0, 0, 5, 5}));
  EXPECT_EQ(ends_of(moves, 'C'), (AxisEnds{0, 0, 7, 7}));
  EXPECT_EQ(moves[1].auxiliary.begin_rad_mm, moves[0].auxiliary.end_rad_mm);
  EXPECT_EQ(std::get<LineMove>(moves[0].shape).end_mm, moves[0].start_mm);
  EXPECT_TRUE(moves[2].rapid);
}

TEST(ExtraAxes, KeepTheirPlaceOnEveryOtherMove) {
  const auto moves = moves_with(kA, "G1 A90 F360\nG1 X10 F100\nG2 X20 I5\nG4 P1\nG0 Z3");
  EXPECT_EQ(ends_of(moves, 'A'), (AxisEnds{90, 90, 90, 90, 90}));
  for (std::size_t i = 1; i < moves.size(); ++i) {
    EXPECT_FALSE(moves[i].auxiliary.moves());
  }
}

TEST(ExtraAxes, OfNoLengthAreNotDelivered) {
  EXPECT_EQ(moves_with(kA, "G1 A90 F360\nG1 A90\nG0 A90 X0").size(), 1U);
}

// rs274 prints program coordinates: 90 with A5 as origin is 95 on the machine; G92 A0 there puts
// 10 to 105; G53 A1 is 1; G28 A0 goes by way of program 0, which is 5, to 0.
TEST(ExtraAxes, HaveOffsetsAndHomes) {
  const auto moves = moves_with(kA,
                                "G10 L2 P1 A5\nG1 A90 F360\nG92 A0\nG1 A10\nG92.1\nG53 G1 A1\n"
                                "G28 A0\nG52 A2\nG0 A1\nG52 A0\nG10 L20 P1 A30\nG0 A0\nG28");
  EXPECT_EQ(ends_of(moves, 'A'), (AxisEnds{95, 105, 1, 5, 0, 8, -22, 0}));
}

TEST(ExtraAxes, TakeStoredOffsetsUpAgain) {
  const auto moves = moves_with(kU,
                                "G20\nG92 U1\nG0 U2\nG92.2\nG0 U0\nG92.3\nG0 U1\nG28.1\n"
                                "G0 U5\nG28\nG55 G0 U0");
  EXPECT_EQ(ends_of(moves, 'U'), (AxisEnds{25.4, 0, 101.6, 0, -25.4}));
}

TEST(ExtraAxes, CountInInchesWhereTheyGoStraightAndInDegreesWhereTheyTurn) {
  const auto moves = moves_with(kAll, "G20 G0 U1 A1\nG21 G0 V1 W2 C-370");
  EXPECT_EQ(ends_of(moves, 'U'), (AxisEnds{25.4, 25.4}));
  EXPECT_EQ(ends_of(moves, 'A'), (AxisEnds{1, 1}));
  EXPECT_EQ(ends_of(moves, 'W'), (AxisEnds{0, 2}));
  EXPECT_EQ(ends_of(moves, 'C'), (AxisEnds{0, -370}));
}

TEST(ExtraAxes, TakeFAlongXyzElseAlongUvwElseInDegrees) {
  const auto moves = moves_with(kAll,
                                "G1 X3 A90 U1 F600\nG1 U2 A0 F120\nG1 A10 B10 F360\n"
                                "G20 G1 C5 F720");
  EXPECT_DOUBLE_EQ(moves.at(0).feedrate_mm_s, 10.0);
  EXPECT_DOUBLE_EQ(moves.at(1).feedrate_mm_s, 2.0);
  EXPECT_DOUBLE_EQ(moves.at(2).feedrate_mm_s, 6.0 * kDegree);
  EXPECT_DOUBLE_EQ(moves.at(3).feedrate_mm_s, 12.0 * kDegree);
}

TEST(ExtraAxes, TakeTheLengthOfTheSameGroupInInverseTime) {
  const auto moves = moves_with(kAll,
                                "G93\nG1 X3 Y4 A90 F2\nG1 U3 V4 A0 F2\nG1 A3 B4 F2\n"
                                "G2 X6 I1.5 A90 F60");
  EXPECT_DOUBLE_EQ(moves.at(0).feedrate_mm_s, 5.0 * 2 / 60);
  EXPECT_DOUBLE_EQ(moves.at(1).feedrate_mm_s, 5.0 * 2 / 60);
  EXPECT_NEAR(moves.at(2).feedrate_mm_s, 5.0 * kDegree * 2 / 60, 1e-15);
  EXPECT_GT(moves.at(3).feedrate_mm_s, 3.0);
}

TEST(ExtraAxes, TurnPerRevolutionOfTheSpindle) {
  const auto moves = moves_with(kA, "M3 S60 G95 F2\nG1 A10");
  EXPECT_DOUBLE_EQ(moves.at(1).feedrate_mm_s, 2.0 * kDegree);
}

TEST(ExtraAxes, GoAlongWithArcsAndHelices) {
  const auto moves = moves_with(kA, "G2 X20 I10 Z5 A45 F300");
  EXPECT_EQ(ends_of(moves, 'A'), AxisEnds{45});
  EXPECT_DOUBLE_EQ(moves.at(0).feedrate_mm_s, 5.0);
}

TEST(ExtraAxes, AreRefusedWhereOnlyXyzCanMove) {
  EXPECT_EQ(first_message_with(kA, "G99 G81 X1 Z-1 R1 A90 F100"),
            "1:19: error: A cannot be used in a canned cycle");
  EXPECT_EQ(first_message_with(kU, "G38.3 Z-1 U2 F100"),
            "1:11: error: U cannot be used with G38.3");
  EXPECT_EQ(first_message_with(kU, "G5 X1 Y1 I1 J1 P1 Q1 U2 F100"),
            "1:22: error: U cannot be used with G5");
  EXPECT_EQ(first_message_with(kU, "G41.1 D1\nG1 X5 U2 F100"),
            "2:7: error: U cannot be used while G41/G42 is active");
  EXPECT_EQ(first_message_with(kU, "G10 L1 P1 U2"), "1:11: error: U cannot be used with G10 L1");
  EXPECT_EQ(first_message_with(kU, "G43.1 U2"),
            "1:7: error: U cannot be used with G43.1 and G43.2");
  EXPECT_EQ(first_message_with(kU, "G41.1 D1\nG1 X5 F100\nX9\nG40\nU2"),
            "5:1: error: U cannot be used in the move that ends G41/G42");
  EXPECT_EQ(first_message_with(kA, "G6.2 Q1 P2 K0 X0 Y0 R1 A3 F100"),
            "1:24: error: G6.2: A is not allowed inside a curve");
}

TEST(ExtraAxes, StayInRange) {
  EXPECT_EQ(first_message_with(kA, "G91 G0 A999999\nG0 A1"),
            "2:4: error: A: 1 leads outside -999999.999..999999.999 degrees");
}

// A turned work offset moves X by its Y's rounding; that is no way of X and Y.
TEST(ExtraAxes, MoveAloneWhereXyzMoveByRoundingOnly) {
  const auto moves = moves_with(kA, "G10 L2 P1 X0.1 Y0.3 R33\nG0 X12.3 Y45.6\nG1 X12.3 A5 F60");
  EXPECT_EQ(std::get<LineMove>(moves.at(1).shape).end_mm, moves.at(1).start_mm);
  EXPECT_DOUBLE_EQ(moves.at(1).feedrate_mm_s, kDegree);
}

TEST(ExtraAxes, AreReadThroughParameters) {
  const auto moves = moves_with(
      letters('A', 'U'),
      "G10 L2 P1 A5 U2\nG0 A90 U8\nG20\nG28.1\nG92 A0\n"
      "G0 X[#5423] Y[#5426*25.4] Z[#<_abs_a>]\nG0 X#5224 Y#5227 Z#5164\nG0 X#5214 Y#<_u>");
  const auto expect_inches = [&](std::size_t move, const Point& wanted) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::get<LineMove>(moves.at(move).shape).end_mm[axis], wanted[axis] * 25.4, 1e-9);
    }
  };
  expect_inches(1, {0, 8, 95});
  expect_inches(2, {5, 2, 95});
  expect_inches(3, {90, 8 / 25.4, 95});
}

TEST(ExtraAxes, AreReadInTheFanucDialectToo) {
  const auto moves =
      moves_with(letters('A', 'B'), "G0 A90.\nG54.1 P2\nG10 L20 P2 B5.\nG0 B0", Dialect::fanuc);
  EXPECT_EQ(ends_of(moves, 'B'), (AxisEnds{0, 5}));
}

TEST(ExtraAxes, CountInLeastIncrementsOfADegree) {
  ReaderOptions options = with_axes(kA, Dialect::fanuc);
  options.machine.least_increment_mm = 0.001;
  const Program program = read_program("G20 G0 A90000\nA45.\nM2\n", options);
  EXPECT_NEAR(program.moves.at(0).auxiliary.end_rad_mm[0], 90 * kDegree, 1e-12);
  EXPECT_NEAR(program.moves.at(1).auxiliary.end_rad_mm[0], 45 * kDegree, 1e-12);
}

// Found by the fuzzer: the F of a block with an error was known to X, Y and Z alone.
TEST(ExtraAxes, KnowTheFeedrateOfABlockWithAnError) {
  const Program program = read_program("G21 G90 G1 X1 F600 XOY\nA10\nM2\n", with_axes(kA));
  EXPECT_EQ(program.diagnostics.size(), 1U);
  for (const Move& move : program.moves) {
    if (move.source.line == 2) {
      EXPECT_NEAR(move.feedrate_mm_s, 10.0 * kDegree, 1e-12);  // 600 degrees a minute
    }
  }
}

// Found by the fuzzer: after "no feed set" moves go on at some feedrate, these at none.
TEST(ExtraAxes, GoOnAtSomeFeedrateOnceItIsSaidThatNoneIsSet) {
  const Program program = read_program("G21 G90 G1 X1\nA10\nM2\n", with_axes(kA));
  EXPECT_EQ(program.diagnostics.size(), 1U);
  ASSERT_FALSE(program.moves.empty());
  for (const Move& move : program.moves) {
    EXPECT_TRUE(move.source.line != 2 || move.feedrate_mm_s > 0.0);
  }
}

}  // namespace
}  // namespace kerf::parser
