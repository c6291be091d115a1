// Spindle, tools, coolant, inputs and outputs, overrides, saved modes.
#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

std::vector<std::string> lines_read(std::string_view text) {
  std::vector<std::string> lines;
  for (const Move& move : moves_of(text)) {
    lines.push_back(text_of(move));
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(OutputChanges, ComeInTheOrderOfRs274) {
  EXPECT_EQ(lines_read("G0 X1 G4 P2 M8 M3 S100 M6 T4"),
            (Lines{"1: tool 4", "1: spindle cw 100", "1: flood on 0", "1: dwell 2",
                   "1: rapid to 1 0 0"}));
  EXPECT_EQ(lines_read("M6 T4 M64 P1"), (Lines{"1: digital 1 = 1", "1: tool 4"}));
}

TEST(OutputChanges, OfOutputsCarryNumberAndValue) {
  EXPECT_EQ(lines_read("M62 P1\nM63 P2\nM64 P63\nM65 P0\nM67 E1 Q2.5\nM68 E7 Q-3"),
            (Lines{"1: digital at motion 1 = 1", "2: digital at motion 2 = 0", "3: digital 63 = 1",
                   "4: digital 0 = 0", "5: analog at motion 1 = 2.5", "6: analog 7 = -3"}));
}

TEST(OutputChanges, WaitForInputsThatStayLow) {
  EXPECT_EQ(lines_read("M66 P0 L0\nM66 P1 L4 Q5\nM66 E0"),
            (Lines{"1: dwell 0", "2: dwell 0", "3: dwell 0"}));
  EXPECT_EQ(lines_read("M66 P1 L3 Q5\nM66 P0 L1 Q0.5"), (Lines{"1: dwell 5", "2: dwell 0.5"}));
}

TEST(OutputChanges, RefuseWordsThatMakeNoSense) {
  EXPECT_EQ(first_message("M64"), "1:1: error: M64 needs P");
  EXPECT_EQ(first_message("M64 P64"), "1:5: error: M64: P must be 0 to 63, found 64");
  EXPECT_EQ(first_message("M64 P0.5"), "1:5: error: M64: P must be 0 to 63, found 0.5");
  EXPECT_EQ(first_message("M68 Q1"), "1:1: error: M68 needs E");
  EXPECT_EQ(first_message("M68 E8 Q1"), "1:5: error: M68: E must be 0 to 7, found 8");
  EXPECT_EQ(first_message("M68 E0"), "1:1: error: M68 needs Q (the value)");
  EXPECT_EQ(first_message("M66"),
            "1:1: error: M66 needs P (digital input) or E (analog input), and not both");
  EXPECT_EQ(first_message("M66 P0 L5 Q1"), "1:8: error: M66: L must be 0 to 4, found 5");
  EXPECT_EQ(first_message("M66 E0 L3 Q1"),
            "1:8: error: M66: L must be 0 for an analog input, found 3");
  EXPECT_EQ(first_message("M66 P0 L3"),
            "1:1: error: M66 L3: Q (seconds) must be greater than 0, found 0");
  EXPECT_EQ(first_message("M50 P2"), "1:5: error: M50: P must be 0 or 1, found 2");
  EXPECT_EQ(first_message("M62 P0 M64 P1"), "1:8: error: M62 and M64 are in the same modal group");
  EXPECT_EQ(first_message("M61"), "1:1: error: M61 needs Q (the tool's number)");
  EXPECT_EQ(first_message("M61 Q1.5"), "1:5: error: M61: Q must be a tool's number, found 1.5");
  EXPECT_EQ(first_message("M64 P0 G4"), "1:5: error: P has two users in this block");
}

TEST(OutputChanges, OrientTheSpindle) {
  const auto moves = moves_of("M3 S100\nM19 R90 P1 Q2");
  const auto& event = std::get<EventMove>(moves.at(1).shape);
  EXPECT_EQ(event.kind, EventKind::spindle_orient);
  EXPECT_DOUBLE_EQ(event.value, 1.5707963267948966);
  EXPECT_EQ(first_message("M19 R0 P3"), "1:8: error: M19: P must be 0, 1 or 2, found 3");
  EXPECT_EQ(first_message("M19 R0 Q0"),
            "1:8: error: M19: Q (seconds) must be greater than 0, found 0");
}

TEST(OutputChanges, OfToolsChangeOrOnlyNameIt) {
  EXPECT_EQ(lines_read("T3 M6\nM61 Q5\nM60"),
            (Lines{"1: tool 3", "2: tool number 5", "3: pallet 0"}));
  EXPECT_EQ(lines_read("G10 L1 P5 Z7\nM61 Q5\nG43\nG0 Z0"),
            (Lines{"2: tool number 5", "4: rapid to 0 0 7"}));
}

TEST(Spindle, FeedPerRevolutionFollowsTheSpeed) {
  EXPECT_DOUBLE_EQ(moves_of("G95 F0.1 S600 M3\nG1 X1").at(1).feedrate_mm_s, 0.1 * 600 / 60);
  EXPECT_DOUBLE_EQ(moves_of("G20 G95 F0.1 S600 M3\nG1 X1").at(1).feedrate_mm_s, 25.4);
  EXPECT_EQ(first_message("G95 F0.1 G1 X1"),
            "1:10: error: G95 is active: feed per revolution needs a spindle speed (S)");
  EXPECT_EQ(first_message("S100 G95 F0.1 G1 X1\nX2"),
            "1:15: warning: G95 with the spindle stopped: the feed of S100 is taken");
  EXPECT_EQ(read_program("S100 G95 F0.1 G1 X1\nX2\nX3\nM2\n").diagnostics.size(), 1U);
  EXPECT_EQ(first_message("G95 S100 M3\nG1 X1"), "2:1: error: no feed set: G1 needs F");
  EXPECT_EQ(first_message("F100\nG95 S100 M3\nG1 X1"), "3:1: error: no feed set: G1 needs F");
}

// At 50 mm from X0 a surface speed of 100 m/min is 100000 / (2 pi 50) revolutions per minute.
TEST(Spindle, KeepsTheSurfaceSpeedWhereItIsTold) {
  EXPECT_EQ(lines_read("G0 X50\nG96 S100 M3\nG97 S200\nG96 D300 S100").at(1),
            "2: spindle cw 318.309886184");
  EXPECT_EQ(lines_read("G0 X50\nG96 S100 M3\nG97 S200\nG96 D300 S100").at(3), "4: spindle cw 300");
  EXPECT_EQ(lines_read("G96 D300 S100 M3").at(0), "1: spindle cw 300") << "at X0";
  EXPECT_EQ(lines_read("G0 X50\nG96 S100 M3\nG97 M4").at(2), "3: spindle ccw 318.309886184")
      << "the speed there was";
  EXPECT_EQ(first_message("G96"), "1:1: error: G96 needs S (surface speed)");
  EXPECT_EQ(first_message("G96 S1 D-1"), "1:8: error: G96: D (highest speed) must not be negative");
}

// 300 feet/min, at 25.4 mm from X0; the same in G21. As LinuxCNC, which hears of S with its unit.
TEST(Spindle, KeepsTheSurfaceSpeedWhereTheUnitsChange) {
  EXPECT_EQ(lines_read("G20 G90 G96 S300 D10000 M3\nG0 X1\nG21\nG97 M3").back(),
            "4: spindle cw 572.957795131");
  EXPECT_EQ(lines_read("G21 G90 G96 S100 D10000 M3\nG0 X50\nG20\nG97 M3").back(),
            "4: spindle cw 318.309886184");
  EXPECT_EQ(lines_read("G20 G96 S300 D10000 M3\nG0 X1\nM70\nG21\nG96 S7\nM72\nG97 M3").back(),
            "7: spindle cw 572.957795131");
}

TEST(OverrideSwitches, TellWhatTheyChange) {
  EXPECT_EQ(lines_read("M48\nM51 P0\nM51\nM49\nM49"),
            (Lines{"2: speed override 0", "3: speed override 1", "4: speed override 0"}));
  EXPECT_EQ(
      lines_read("M52 P1\nM52\nM53\nM53 P0\nM52 P0\nM53 P1"),
      (Lines{"1: adaptive feed 1", "4: feed stop 0", "5: adaptive feed 0", "6: feed stop 1"}));
}

TEST(OverrideSwitches, OfAdaptiveFeedAreOffWhileTapping) {
  const std::vector<Move> moves = moves_of("M52 P1\nM3 S100 F100\nG84 Z-5 R2\nG80 G1 X1");
  const auto adaptive = [](const Move& move) { return move.follows.adaptive; };
  const auto is_cut = [](const Move& move) {
    return std::holds_alternative<LineMove>(move.shape) && !move.rapid;
  };
  std::vector<bool> cuts;
  for (const Move& move : moves) {
    if (is_cut(move)) {
      cuts.push_back(adaptive(move));
    }
  }
  EXPECT_EQ(cuts, (std::vector<bool>{false, false, true})) << "into the hole, out of it, the line";
}

TEST(SavedModes, BringBackOverrideSwitches) {
  EXPECT_EQ(lines_read("M51 P0\nM70\nM51\nM52\nM72"),
            (Lines{"1: speed override 0", "3: speed override 1", "4: adaptive feed 1",
                   "5: speed override 0", "5: adaptive feed 0"}));
}

TEST(SavedModes, ComeBack) {
  EXPECT_EQ(lines_read("G21 G90 F60\nM70\nG20 G91 G55 F7\nM72\nG1 X1"),
            (Lines{"5: line to 1 0 0 feed 1"}));
  EXPECT_EQ(lines_read("M3 S10 M8\nM70\nM5\nM9\nM72"),
            (Lines{"1: spindle cw 10", "1: flood on 0", "3: spindle off 0", "4: coolant off 0",
                   "5: spindle cw 10", "5: flood on 0"}));
  EXPECT_EQ(first_message("M72"), "1:1: error: M72 without M70: no modes are saved here");
  EXPECT_EQ(first_message("M70\nM71\nM72"), "3:1: error: M72 without M70: no modes are saved here");
  EXPECT_EQ(first_message("M73"),
            "1:1: error: M73 outside a subprogram: there is no return at which it could restore");
}

// As rs274 answers.
TEST(SavedModes, SwitchG92BackOffAndOn) {
  EXPECT_EQ(lines_read("M70\nG92 X5\nM72\nG0 X1\nG92.3\nX1"),
            (Lines{"4: rapid to 1 0 0", "6: rapid to -4 0 0"}));
  EXPECT_EQ(lines_read("G92 X5\nM70\nG92.2\nM72\nG0 X1"), (Lines{"5: rapid to -4 0 0"}));
  EXPECT_EQ(lines_read("G92 X5\nM70\nG92 X7\nM72\nG0 X1"), (Lines{"5: rapid to -6 0 0"}));
}

TEST(SavedModes, LeaveTheOffsetOfAnotherToolAlone) {
  const std::string tools = "G10 L1 P1 Z1\nG10 L1 P2 Z2\n";
  EXPECT_EQ(lines_read(tools + "G43 H1\nM70\nG43 H2\nM72\nG0 Z0").back(), "7: rapid to 0 0 2");
  EXPECT_EQ(lines_read(tools + "G43 H1\nM70\nG49\nM72\nG0 Z0").back(), "7: rapid to 0 0 1");
  EXPECT_EQ(lines_read(tools + "G43 H1\nM70\nM61 Q2\nG49\nM72\nG0 Z0").back(), "8: rapid to 0 0 2");
  EXPECT_EQ(lines_read(tools + "M70\nG43 H1\nM72\nG0 Z5").back(), "6: rapid to 0 0 5");
}

TEST(SavedModes, KeepWhereOffsetsLie) {
  EXPECT_EQ(lines_read("M70\nG10 L2 P1 X5\nG55\nM72\nG0 X1"), (Lines{"5: rapid to 6 0 0"}));
}

}  // namespace
}  // namespace kerf::parser
