// G40, G41, G42, G41.1 and G42.1 in programs: what they take, what they refuse, and where errors
// point. The paths themselves are compared with LinuxCNC's in tests/conformance/compensation.
#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

constexpr const char* kOn = "G41.1 D10 G1 F600 X20\nX50\n";

Program read_with_tools(const std::string& text, Dialect dialect = Dialect::rs274) {
  ReaderOptions options;
  options.machine = default_program_data();
  options.dialect = dialect;
  return read_program(text, options);
}

// The messages, one a line.
std::string messages(const std::string& text, Dialect dialect = Dialect::rs274) {
  std::string all;
  for (const diagnostics::Diagnostic& one : read_with_tools(text, dialect).diagnostics) {
    all += std::to_string(one.source.line) + ":" + std::to_string(one.source.column) + ": " +
           one.message + "\n";
  }
  return all;
}

std::string refusal(const std::string& block) {
  return messages(kOn + block + "\nG40 Y40\nM2\n");
}

std::string moves(const std::string& text, Dialect dialect = Dialect::rs274) {
  std::string all;
  for (const Move& move : read_with_tools(text, dialect).moves) {
    all += text_of(move) + "\n";
  }
  return all;
}

TEST(Compensation, TakesTheRadiusFromTheTable) {
  const std::string path = "1: line to 20 3 0 feed 10\n2: line to 50 3 0 feed 10\n";
  EXPECT_EQ(moves("G41 D2 G1 F600 X20\nX50\nG40 X80\n").substr(0, path.size()), path);
  const std::string loaded = "2: line to 20 3 0 feed 10\n3: line to 50 3 0 feed 10\n";
  EXPECT_EQ(moves("T2 M6\nG41 G1 F600 X20\nX50\nG40 X80\n").substr(10, loaded.size()), loaded);
  EXPECT_EQ(moves("T2 M6\nG41 D0 G1 F600 X20\nX50\nG40 X80\n").substr(10, loaded.size()), loaded);
}

// Found by the fuzzer: G93 divided a programmed length of 0 by the time, and the exit never ended.
TEST(Compensation, LeavesByTimeWhereTheProgrammedExitHasNoLength) {
  const std::string found = moves("G41.1 D10 G93 G1 X20 F2\nX50 F2\nG40 X50 F2\nM2\n");
  // 5 mm, the tool's radius, in half a minute.
  EXPECT_NE(found.find("3: line to 50 0 0 feed 0.1666"), std::string::npos) << found;
}

// Found by the fuzzer: what was held when the text ended was never run.
TEST(Compensation, TakesAnArcTooSmallToBeAMoveForNone) {
  const auto with = [](const std::string& block) {
    const std::string text = kOn + ("G91\n" + block) + "\nG90\nG1 X80 Y30\nG40 Y60\nM2\n";
    EXPECT_EQ(messages(text), "") << block;
    return moves(text);
  };
  const std::string without = with("");
  for (const char* const block :
       {"G2 I[1/10**17]", "G3 J[1/10**9]", "G3 X[1/10**17] I[1/10**17]"}) {
    EXPECT_EQ(with(block), without) << block;
  }
}

// Found by a review: the curve began where the path is, with the tool still beside it.
TEST(Compensation, LeavesByALineAndNoCurve) {
  for (const char* const curve : {"G5 X90 Y30 I10 J0 P0 Q-10", "G5.1 X90 Y30 I10 J10",
                                  "G5.2 X60 Y10 P1 L3\nX90 Y30 P1\nG5.3"}) {
    const std::string found = messages(std::string(kOn) + "G40\n" + curve + "\nG1 X100\nM2\n");
    EXPECT_NE(found.find("the first move after G40 must be a straight line, not a curve"),
              std::string::npos)
        << curve << ": " << found;
  }
}

TEST(Compensation, RunsWhatItHoldsWhereTheTextEndsWithoutM2) {
  EXPECT_EQ(moves(kOn), "1: line to 20 5 0 feed 10\n2: line to 50 5 0 feed 10\n");
  EXPECT_EQ(moves("O1\nG41 D2 G1 F600 X20\nX50\nO2\nM99\n", Dialect::fanuc),
            "2: line to 20 3 0 feed 10\n3: line to 50 3 0 feed 10\n");
}

TEST(Compensation, GivesTheCornerArcTheLineBehindIt) {
  EXPECT_EQ(moves("G41.1 D10 G1 F600 X20\nX50 F300\nM8\nG0 Y-40\nM0\nG40 X80\nM2\n"),
            "1: line to 20 5 0 feed 10\n"
            "2: line to 50 5 0 feed 5\n"
            "3: flood on 0\n"
            "4: clockwise in xy about 50 0 0 to 55 0 0 turns 1\n"
            "4: rapid to 55 -40 0\n"
            "5: program stop 0\n"
            "6: rapid to 80 -40 0\n"
            "7: program end 0\n");
}

TEST(Compensation, EndsOnTheMoveBehindG40EvenIfItGoesNowhere) {
  EXPECT_EQ(moves("G41.1 D10 G1 F600 X20\nX50\nG40 X50\nM2\n"),
            "1: line to 20 5 0 feed 10\n"
            "2: line to 50 5 0 feed 10\n"
            "3: line to 50 0 0 feed 10\n"
            "4: program end 0\n");
}

TEST(Compensation, PlungesBeforeTheEntry) {
  EXPECT_EQ(moves("G41.1 D10\nG1 F600 Z-5\nX20\nX50\nG40 Y-40\nM2\n"),
            "2: line to 0 0 -5 feed 10\n"
            "3: line to 20 5 -5 feed 10\n"
            "4: line to 50 5 -5 feed 10\n"
            "5: line to 50 -40 -5 feed 10\n"
            "6: program end 0\n");
}

TEST(Compensation, RefusesWhatWouldShiftTheContour) {
  const auto cannot = [](const std::string& code) {
    return "3:1: " + code +
           " cannot be used while cutter compensation is active: cancel with G40 first\n";
  };
  EXPECT_EQ(refusal("G53 G0 X60"), cannot("G53"));
  EXPECT_EQ(refusal("G28 X60"), cannot("G28"));
  EXPECT_EQ(refusal("G30"), cannot("G30"));
  EXPECT_EQ(refusal("G28.1"), cannot("G28.1"));
  EXPECT_EQ(refusal("G92 X0"), cannot("G92"));
  EXPECT_EQ(refusal("G52 X1"), cannot("G52"));
  EXPECT_EQ(refusal("G10 L2 P1 X5"), cannot("G10"));
  EXPECT_EQ(refusal("G10 L20 P1 X5"), cannot("G10"));
  EXPECT_EQ(refusal("M6 T2"), cannot("M6"));
  EXPECT_EQ(refusal("M61 Q2"), cannot("M61"));
  EXPECT_EQ(refusal("G43 H1"), cannot("G43"));
  EXPECT_EQ(refusal("G49"), cannot("G49"));
  EXPECT_EQ(refusal("G55"), cannot("G55"));
  EXPECT_EQ(refusal("G18"), "3:1: plane cannot change (XY to XZ) while G41/G42 is active\n");
  EXPECT_EQ(refusal("G5.1 X60 Y10 I5 J5"), "3:1: G5.1 cannot be used while G41/G42 is active\n");
  EXPECT_EQ(refusal("G42 D1"), "3:1: G42 while G41.1 is active: cancel with G40 first\n");
  for (const char* allowed : {"G17", "G92.1", "T2", "M0", "M8", "S100", "G4 P1", "G64 P0.1", "G61",
                              "G94", "G10 L1 P2 R3", "G80 G1", "M62 P1"}) {
    EXPECT_EQ(refusal(allowed), "") << allowed;
  }
  EXPECT_EQ(messages(std::string(kOn) + "G40 G49 G54 G53 G1 X90 Y60\nM2\n"), "");
}

TEST(Compensation, LetsNoSavedModesMoveTheContour) {
  EXPECT_EQ(
      messages("F600 M70\nG55\nG10 L2 P2 X5\n" + std::string(kOn) + "M72\nX60\nG40 Y40\nM2\n"),
      "6:1: the saved modes (M70, M73) have another plane or other offsets: they cannot come "
      "back while cutter compensation is active\n");
  EXPECT_EQ(messages("F600 M70\n" + std::string(kOn) + "M72\nX60\nG40 Y40\nM2\n"), "");
  EXPECT_EQ(messages("F600\n" + std::string(kOn) + "M70\nX60\nM72\nX70\nG40 Y40\nM2\n"), "");
}

TEST(Compensation, ChecksItsWords) {
  EXPECT_EQ(messages("G41 D-1\nM2\n"), "1:5: D must not be negative\n");
  EXPECT_EQ(messages("G41 D1.5\nM2\n"),
            "1:5: D must be a whole number (of a tool; G41.1 and G42.1 take a diameter)\n");
  EXPECT_EQ(messages("G42 D99\nM2\n"), "1:5: D99 is not in the tool table\n");
  EXPECT_EQ(messages("G41.1\nM2\n"), "1:1: G41.1 needs D (the tool's diameter)\n");
  EXPECT_EQ(messages("G41.1 D5 L1\nM2\n"),
            "1:10: L (orientation of a turning tool) can be used only in the XZ plane (G18)\n");
  EXPECT_EQ(messages("G18 G41.1 D5 L10\nM2\n"),
            "1:14: L (orientation of a turning tool) must be a whole number from 0 to 9, found "
            "10\n");
  EXPECT_EQ(messages("G19 G42.1 D5\nM2\n"),
            "1:5: G42.1 works in the planes XY (G17) and XZ (G18), not in YZ (G19)\n");
}

TEST(Compensation, BlamesTheMoveAndShowsItsBlock) {
  const Program program =
      read_with_tools("G41.1 D10 G1 F600 X20\nX50\n  Y3 (too short)\nX20\nY30\nX0\nG40 X-40\nM2\n");
  ASSERT_FALSE(program.diagnostics.empty());
  const diagnostics::Diagnostic& first = program.diagnostics.front();
  EXPECT_EQ(to_string(first, "slot").substr(0, 60),
            "slot:3:3: error: the tool (radius 5.000 mm) cannot reach lin");
  EXPECT_EQ(first.block.text, "  Y3 (too short)");
  EXPECT_EQ(first.block.caret, 2U);
}

TEST(Compensation, LeavesTheContourAloneAfterAnErrorInIt) {
  EXPECT_EQ(messages("G41.1 D10 G1 F600 X20\nX50\nX60 Q1\nX70 Y3\nX80 Y0\nG40 Y40\nM2\n"),
            "3:5: Q is not used in this block\n");
}

TEST(Compensation, KeepsDInForceWithFanuc) {
  const std::string path =
      "2: line to 20 3 0 feed 10\n3: line to 50 3 0 feed 10\n4: line to 50 40 0 feed 10\n"
      "5: program end 0\n";
  EXPECT_EQ(moves("D2\nG41 G1 F600 X20.\nX50.\nG40 Y40.\nM30\n", Dialect::fanuc), path);
  EXPECT_EQ(messages("D2\nG41 G1 F600 X20.\nX50.\nG40 Y40.\nM30\n", Dialect::fanuc), "");
}

}  // namespace
}  // namespace kerf::parser
