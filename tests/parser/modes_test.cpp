#include <gtest/gtest.h>

#include "parser/text/text.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

TEST(Modes, ALineOfZeroLengthIsNoMove) {
  EXPECT_EQ(moves_of("F60 G1 X1\nG1 X1\nX1 Y0\nG0 X1").size(), 1U);
}

TEST(Modes, WordsOfOtherCodesDoNotDisturbAModalArc) {
  EXPECT_EQ(first_message("F60 G2 X2 I1\nG4 P1\nG64 P0.1\nM8\nS5"), "no message");
  EXPECT_EQ(first_message("F60 G2 X2 I1\nP3"), "2:1: error: P is not used in this block");
}

TEST(Modes, FeedSurvivesAChangeOfUnitsAsASpeed) {
  const auto moves = moves_of("G21 F254 G1 X1\nG20 X2");
  EXPECT_DOUBLE_EQ(moves.at(1).feedrate_mm_s, 254.0 / 60.0);
}

TEST(Modes, FeedInTheBlockOfAChangeOfUnitsIsInTheNewUnits) {
  EXPECT_DOUBLE_EQ(moves_of("G20 G1 X1 F10").at(0).feedrate_mm_s, 254.0 / 60.0);
}

TEST(Modes, AChangeOfTheFeedModeForgetsTheFeed) {
  EXPECT_NE(first_message("F60 G1 X1\nG93\nG94\nX2").find("no feed set"), std::string::npos);
  EXPECT_EQ(first_message("F60 G1 X1\nG94\nX2"), "no message");
}

TEST(Modes, MissingFeedIsReportedOnce) {
  const Program program = read_program("G1 X1\nX2\nX3\nM2\n");
  EXPECT_EQ(program.diagnostics.size(), 1U);
}

TEST(Modes, CancelWordsAreAccepted) {
  EXPECT_EQ(first_message("G40 G49 G80 G17 G54 G94 G91.1 G21 G90 G61"), "no message");
  EXPECT_EQ(first_message("G0 G40 G80 X1"), "no message");
}

TEST(Modes, WorkOffsetsAreZero) {
  EXPECT_EQ(text_of(moves_of("G55 G0 X1\nG53 G0 X1 Y2").at(1)), "2: rapid to 1 2 0");
}

TEST(Modes, ADwellAndAMoveOfOneBlockComeInThatOrder) {
  const auto moves = moves_of("G4 P0.5 G0 X1");
  ASSERT_EQ(moves.size(), 2U);
  EXPECT_DOUBLE_EQ(std::get<DwellMove>(moves[0].shape).duration_s, 0.5);
}

TEST(Modes, PointAtTheFirstWordOfTheirBlock) {
  const auto moves = moves_of("\n  N7 G0 X1");
  EXPECT_EQ(moves.at(0).source.line, 2U);
  EXPECT_EQ(moves.at(0).source.column, 3U);
}

// A machine whose defaults cannot be taken for numbers of the program.
std::string tolerances_of(const std::string& text) {
  MachineData machine;
  machine.corner_tolerance_mm = 0.03;
  machine.merge_tolerance_mm = 0.004;
  const Program program = read_program("F60 " + text + "\nG1 X9\nM2\n", {.machine = machine});
  EXPECT_TRUE(program.diagnostics.empty()) << text;
  const Move& move = program.moves.at(program.moves.size() - 2);
  return shortest(move.blend_tolerance_mm) + " " + shortest(move.merge_tolerance_mm);
}

TEST(Modes, BlendingAndMergingTakeTheirTolerancesFromG64) {
  EXPECT_EQ(tolerances_of("G64 P0.1 Q0.05"), "0.1 0.05");
  EXPECT_EQ(tolerances_of("G64 P0.1 Q0.2"), "0.1 0.2");
  EXPECT_EQ(tolerances_of("G20 G64 P0.1 Q0.05"), "2.54 1.27");
}

TEST(Modes, MergingIsAllowedAsMuchAsBlendingWhereG64HasPAlone) {
  EXPECT_EQ(tolerances_of("G64 P0.1"), "0.1 0.1");
  EXPECT_EQ(tolerances_of("G64 P0"), "0 0");
}

TEST(Modes, WhatG64DoesNotSayTheMachineSays) {
  EXPECT_EQ(tolerances_of("G64"), "0.03 0.004");
  EXPECT_EQ(tolerances_of("G64 Q0.05"), "0.03 0.05");
  EXPECT_EQ(tolerances_of("G20 G64"), "0.03 0.004");
  EXPECT_EQ(tolerances_of("G64 P0.2 Q0.1\nG64"), "0.03 0.004");
}

TEST(Modes, AToleranceOfZeroIsNone) {
  EXPECT_EQ(tolerances_of("G64 P0 Q0.1"), "0 0.1");
  EXPECT_EQ(tolerances_of("G64 P0.1 Q0"), "0.1 0");
  EXPECT_EQ(tolerances_of("G64 Q0"), "0.03 0");
}

TEST(Modes, TheExactPathAndTheExactStopHaveNoTolerance) {
  EXPECT_EQ(tolerances_of("G21"), "0 0");
  EXPECT_EQ(tolerances_of("G64 P0.1\nG61"), "0 0");
  EXPECT_EQ(tolerances_of("G64 P0.1 Q0.2\nG61.1"), "0 0");
}

TEST(Modes, TolerancesComeBackWithTheSavedModes) {
  EXPECT_EQ(tolerances_of("G64 P0.1 Q0.2\nM70\nG61\nM72"), "0.1 0.2");
  EXPECT_EQ(tolerances_of("G61\nM70\nG64 P0.1\nM72"), "0 0");
}

TEST(Modes, AMachineThatSaysNothingBlendsWithinAHundredthOfAMillimetre) {
  const auto moves = moves_of("F60 G64 G1 X1");
  EXPECT_EQ(moves.at(0).blend_tolerance_mm, 0.01);
  EXPECT_EQ(moves.at(0).merge_tolerance_mm, 0.01);
}

TEST(Modes, ANegativeToleranceIsAnError) {
  EXPECT_EQ(first_message("G64 P-0.1"), "1:5: error: G64: P (tolerance) must not be negative");
  EXPECT_EQ(first_message("G64 P0.1 Q-0.2"),
            "1:10: error: G64: Q (merging tolerance) must not be negative");
}

TEST(Modes, DiameterModeIsForLathes) {
  EXPECT_EQ(first_message("G7"),
            "1:1: error: G7 (diameter or radius on X) is for lathes, this machine is a mill");
}

TEST(Modes, EveryCodeUpToAThousandIsKnownOrRefused) {
  int known = 0;
  int later = 0;
  for (int tenths = 0; tenths < 10'000; ++tenths) {
    const std::string code = std::to_string(tenths / 10) + "." + std::to_string(tenths % 10);
    const std::string message = first_message("F60 G" + code);
    later += message.find("is not supported") != std::string::npos ? 1 : 0;
    known += message.find("is not known") == std::string::npos ? 1 : 0;
  }
  EXPECT_GT(known - later, 60) << "codes that run";
}

}  // namespace
}  // namespace kerf::parser
