// Fanuc: G54.1, G50 and G51, G68 and G69. Expected places from the geometry.
#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  const Program program = read_program(std::string(text) + "\nM2\n", {.dialect = Dialect::fanuc});
  std::vector<std::string> lines;
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    std::string message = to_string(diagnostic, "program");
    lines.push_back(message.substr(0, message.find(" [E")));
  }
  for (const Move& move : program.moves) {
    if (!std::holds_alternative<EventMove>(move.shape)) {
      lines.push_back(text_of(move));
    }
  }
  return lines;
}

using Lines = std::vector<std::string>;

TEST(Shape, TurnsTheProgramAboutAPoint) {
  EXPECT_EQ(
      lines_of("G0 X2 Y1\nG68 X1 Y1 R90\nG0 X3 Y1\nG91 X1\nG90 G69 X0 Y0"),
      (Lines{"1: rapid to 2 1 0", "3: rapid to 1 3 0", "4: rapid to 1 4 0", "5: rapid to 0 0 0"}));
  EXPECT_EQ(lines_of("G0 X2 Y1\nG68 R90\nG0 X3 Y1").back(), "3: rapid to 2 2 0")
      << "about where the tool is";
  EXPECT_EQ(lines_of("G68 X0 Y0 R45\nG91 G68 X0 Y0 R45\nG90 G0 X3 Y0").back(), "3: rapid to 0 3 0");
}

// FANUC 30i user's manual B-63944EN-2, scaling and coordinate system rotation: the centre of the
// turn is scaled, too; moves are scaled first and turned then.
TEST(Shape, ScalesTheCentreOfATurn) {
  const std::string turned = "G51 X0 Y0 Z0 P2000\nG68 X1 Y1 R90\n";
  EXPECT_EQ(lines_of(turned + "G0 X2 Y1").back(), "3: rapid to 2 4 0");
  EXPECT_EQ(lines_of("G0 X3 Y1\n" + turned + "G0 X1 Y1").back(), "4: rapid to 2 2 0");
  EXPECT_EQ(lines_of(turned + "G69\nG0 X2 Y1").back(), "4: rapid to 4 2 0");
  EXPECT_EQ(lines_of("G51 X0 Y0 Z0 P2000\nG0 X1 Y1\nG68 R90\nG0 X2 Y1").back(), "4: rapid to 2 4 0")
      << "about where the tool is";
}

TEST(Shape, TurnsArcs) {
  EXPECT_EQ(lines_of("G68 X0 Y0 R90\nF60 G2 X2 I1").back(),
            "2: clockwise in xy about 0 1 0 to 0 2 0 turns 1 feed 1");
  EXPECT_EQ(lines_of("G68 X0 Y0 R90\nF60 G3 X1 Y1 R1").back(),
            "2: counterclockwise in xy about -1 0 0 to -1 1 0 turns 1 feed 1");
}

TEST(Shape, ScalesTheProgramAboutAPoint) {
  EXPECT_EQ(lines_of("G51 X1 Y0 Z0 P2000\nG0 X3 Y1 Z2\nG91 X1\nG50 G90 X0"),
            (Lines{"2: rapid to 5 2 4", "3: rapid to 7 2 4", "4: rapid to 0 2 4"}));
  EXPECT_EQ(lines_of("G51 X0 Y0 Z0 P0.5\nG0 X3 Y1").back(), "2: rapid to 1.5 0.5 0");
  EXPECT_EQ(lines_of("G51 X0 Y0 P2.\nF60 G2 X2 R1").back(),
            "2: clockwise in xy about 2 0 0 to 4 0 0 turns 1 feed 1");
}

TEST(Shape, MirrorsTurnTheSenseOfArcs) {
  EXPECT_EQ(lines_of("G51 X0 Y0 I-1. J1.\nF60 G2 X2 I1").back(),
            "2: counterclockwise in xy about -1 0 0 to -2 0 0 turns 1 feed 1");
  EXPECT_EQ(lines_of("G51 X0 Y0 I-1. J1.\nF60 G2 X1 Y1 R1").back(),
            "2: counterclockwise in xy about -1 0 0 to -1 1 0 turns 1 feed 1");
}

TEST(Shape, MirrorsAxesAboutCoordinates) {
  EXPECT_EQ(lines_of("G51.1 X10\nG0 X13 Y1\nG51.1 Y2\nX13 Y1\nG50.1 X0\nX13 Y1\nG50.1\nX13 Y1"),
            (Lines{"2: rapid to 7 1 0", "4: rapid to 7 3 0", "6: rapid to 13 3 0",
                   "8: rapid to 13 1 0"}));
  EXPECT_EQ(lines_of("G0 X4\nG51.1 X5\nG91 G0 X1").back(), "3: rapid to 3 0 0");
  EXPECT_EQ(lines_of("G52 X100\nG51.1 X1\nG0 X3").back(), "3: rapid to 99 0 0")
      << "the mirror stands in the program's coordinates";
}

TEST(Shape, MirrorsReverseArcsTurnsAndTheSideOfTheCutter) {
  EXPECT_EQ(lines_of("G51.1 X0\nF60 G2 X2 I1").back(),
            "2: counterclockwise in xy about -1 0 0 to -2 0 0 turns 1 feed 1");
  EXPECT_EQ(lines_of("G51.1 X0 Y0\nF60 G2 X2 I1").back(),
            "2: clockwise in xy about -1 0 0 to -2 0 0 turns 1 feed 1");
  EXPECT_EQ(lines_of("G51.1 X0\nG68 X0 Y0 R90\nG0 X2 Y1").back(), "3: rapid to 1 2 0")
      << "(2, 1) turned is (-1, 2), in the mirror (1, 2)";
  // The mirror image of a contour is as far from the mirror image of the tool's way.
  EXPECT_EQ(lines_of("G51.1 X0\nG41.1 D4 G1 F60 X20.\nX40.\nG40 X60. Y-9.").front(),
            "2: line to -20 2 0 feed 1");
  EXPECT_EQ(lines_of("G51 X0 Y0 I-1. J1.\nG41.1 D4 G1 F60 X20.\nX40.\nG40 X60. Y-9.").front(),
            "2: line to -20 2 0 feed 1");
}

TEST(Shape, ChangesMirrorsOnlyOutsideScalesTurnsAndCompensation) {
  EXPECT_EQ(
      lines_of("G68 X0 Y0 R90\nG51.1 X0").front(),
      "program:2:1: error: G51.1 cannot be used while G51 or G68 is active: write G69 and G50 "
      "first");
  EXPECT_EQ(lines_of("G51.1").front(), "program:1:1: error: G51.1 needs at least one axis word");
  EXPECT_EQ(lines_of("G51.1 X0\nG52 X1").front(),
            "program:2:1: error: G52 cannot be used while G51, G51.1 or G68 is active");
  EXPECT_EQ(lines_of("G41.1 D4 G1 F60 X20.\nG51.1 X0\nX40.").front(),
            "program:2:1: error: G51.1 cannot be used while cutter compensation is active: cancel "
            "with G40 first");
}

TEST(Shape, ChoosesExtendedWorkOffsets) {
  EXPECT_EQ(lines_of("G10 L20 P48 X7\nG54.1 P48 G0 X1\nG54 X1"),
            (Lines{"2: rapid to 8 0 0", "3: rapid to 1 0 0"}));
  EXPECT_EQ(lines_of("G0\nG54.1 X5").front(), "program:2:1: error: G54.1 needs P");
  EXPECT_EQ(lines_of("G0\nG54.1 P500 X5").front(),
            "program:2:7: error: G54.1: P must be 1 to 300, found 500");
}

TEST(Fanuc, GoesToMachineCoordinatesAtRapidWhateverTheMode) {
  EXPECT_EQ(lines_of("G54 G52 X5\nG53 Z-3"), (Lines{"2: rapid to 0 0 -3"}));
  EXPECT_EQ(lines_of("G52 X5\nF60 G2 X7 I1\nG53 X0").back(), "3: rapid to 0 0 0");
}

TEST(Shape, SaysWhatIsWrong) {
  EXPECT_EQ(lines_of("G68 X0 Y0").front(), "program:1:1: error: G68 needs R");
  EXPECT_EQ(lines_of("G51 X0 Y0 P0").front(), "program:1:11: error: G51: scale must not be 0");
  EXPECT_EQ(lines_of("G51 X0 Y0 I2. J1.\nF9 G2 X2 I1").front(),
            "program:2:4: error: an arc in the XY plane cannot be scaled by 2 and 1");
  EXPECT_EQ(first_message("G68 X0 Y0 R45"), "1:1: error: G68 is a code of the Fanuc dialect");
}

}  // namespace
}  // namespace kerf::parser
