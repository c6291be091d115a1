// G10, G28, G30, G43, G52, G53, G54 to G59.3, G92 in whole programs. Where a line names rs274, the
// numbers are those of shared tool `rs274 -g`, LinuxCNC 2.9; its tools are T1 Z12.5, T2, T3 Z-3.
#include <gtest/gtest.h>

#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

// The ends of all straight moves, machine coordinates rounded to 0.1 um as rs274 prints them.
std::vector<std::string> ends_of(std::string_view text) {
  const Program program =
      read_program(std::string(text) + "\nM2\n", {.machine = default_program_data()});
  std::vector<std::string> ends;
  for (const diagnostics::Diagnostic& diagnostic : program.diagnostics) {
    ends.push_back(message_line(diagnostic, "program"));
  }
  for (const Move& move : program.moves) {
    if (const auto* line = std::get_if<LineMove>(&move.shape)) {
      Point point = line->end_mm;
      for (double& coordinate : point) {
        coordinate = std::round(coordinate * 1e4) / 1e4;
      }
      ends.push_back(text_of(point));
    }
  }
  return ends;
}

std::string first_message_with_table(std::string_view text) {
  const Program program =
      read_program(std::string(text) + "\nM2\n", {.machine = default_program_data()});
  return program.diagnostics.empty() ? "no message"
                                     : message_line(program.diagnostics.front(), "").substr(1);
}

using Ends = std::vector<std::string>;

TEST(Offsets, PlaceThePathAsRs274Does) {
  EXPECT_EQ(ends_of("G21 G90 F600\nG10 L2 P2 X10 Y20 Z5 R30\nG55 G0 X1 Y2 Z3\nG92 X0 Y0\n"
                    "G0 X1 Y0\nG1 X2\nG53 G0 X1 Y1 Z1\nG91 G1 X1\nG92.2\nG90 G0 X0 Y0\nG92.3\n"
                    "G0 X0 Y0"),
            (Ends{"9.866 22.2321 8", "10.7321 22.7321 8", "11.5981 23.2321 8", "1 1 1",
                  "1.866 1.5 1", "10 20 1", "9.866 22.2321 1"}));
}

TEST(Offsets, TurnArcsWithTheWorkOffset) {
  const auto moves = moves_of("F600 G10 L2 P2 X10 Y20 Z5 R30\nG55 G0 X3 Y2 Z3\nG2 X5 I1");
  const auto& arc = std::get<ArcMove>(moves.at(1).shape);
  // rs274: end 13.3301 24.2321, centre 12.4641 23.7321.
  EXPECT_NEAR(arc.end_mm[0], 13.3301, 1e-4);
  EXPECT_NEAR(arc.end_mm[1], 24.2321, 1e-4);
  EXPECT_NEAR(arc.centre_mm[0], 12.4641, 1e-4);
  EXPECT_NEAR(arc.centre_mm[1], 23.7321, 1e-4);
  const auto absolute =
      moves_of("F600 G90.1 G10 L2 P2 X10 Y20 Z5 R30\nG55 G0 X3 Y2 Z3\nG2 X5 Y2 I4 J2");
  EXPECT_NEAR(std::get<ArcMove>(absolute.at(1).shape).centre_mm[0], arc.centre_mm[0], 1e-12);
  const auto radius = moves_of("F600 G10 L2 P2 X10 Y20 Z5 R30\nG55 G0 X3 Y2 Z3\nG2 X5 Y2 R1");
  EXPECT_NEAR(std::get<ArcMove>(radius.at(1).shape).centre_mm[1], arc.centre_mm[1], 1e-7);
}

TEST(Offsets, TurnSplinesWithTheWorkOffset) {
  const auto moves = moves_of("F600 G10 L2 P1 R90\nG5 X4 Y0 I1 J2 P-1 Q2");
  const auto& points = std::get<NurbsMove>(moves.at(0).shape).points;
  EXPECT_EQ(text_of(points[1].position_mm), "-2 1 0");
  EXPECT_EQ(text_of(points[2].position_mm), "-2 3 0");
  EXPECT_EQ(text_of(points[3].position_mm), "0 4 0");
}

TEST(Offsets, OfToolsLieAlongTheMachine) {
  EXPECT_EQ(ends_of("F600\nG43 H1\nG0 Z10\nG53 G0 Z1\nG0 Z10\nG43.2 H3\nG0 Z10\nG49\nG0 Z10\n"
                    "G43.1 X1 Z2\nG0 X0 Z0"),
            (Ends{"0 0 22.5", "0 0 1", "0 0 22.5", "0 0 19.5", "0 0 10", "1 0 2"}));
  EXPECT_EQ(ends_of("T1 M6\nG43 H0\nG0 Z0\nG43 H2\nG0 Z0\nG49\nG43.2 H1\nG0 Z0"),
            (Ends{"0 0 12.5", "0 0 0", "0 0 12.5"}));
  EXPECT_EQ(ends_of("T1 M6 G43\nG0 Z1"), (Ends{"0 0 13.5"})) << "the tool in the spindle";
  EXPECT_EQ(ends_of("G43 H1\nG43.2 Z2 X1\nG0 X0 Z0"), (Ends{"1 0 14.5"}));
}

TEST(Offsets, HomeGoesByWayOfThePointInTheBlock) {
  EXPECT_EQ(ends_of("F600\nG0 X5 Y6 Z7\nG28.1\nG0 X0 Y0 Z0\nG28 X1 Y2\nG0 X0 Y0 Z0\nG91 G28 Z3\n"
                    "G90 G30\nG0 X1\nG28"),
            (Ends{"5 6 7", "0 0 0", "1 2 0", "5 6 0", "0 0 0", "0 0 3", "0 0 7", "0 0 0", "1 0 0",
                  "5 6 7"}));
  EXPECT_EQ(ends_of("G0 X5 Z3\nG30.1\nG0 X1 Z1\nG0 G91 G30 Z0"), (Ends{"5 0 3", "1 0 1", "1 0 3"}));
}

TEST(Offsets, OfG52AndG92AreTheSame) {
  EXPECT_EQ(
      ends_of("F600\nG52 X10\nG0 X0 Y0\nG52 Y5\nG0 X0 Y0\nG92 X5\nG0 X0\nG52 X0 Y0\nG0 X0 Y0"),
      (Ends{"10 0 0", "10 5 0", "5 5 0", "0 0 0"}));
  EXPECT_EQ(ends_of("G92.3 G0 X1\nG92 X5\nG92.2\nG0 X5\nG52 X1\nG92.3\nG0 X0\nG92.1\nG92.3\nG0 X0"),
            (Ends{"1 0 0", "5 0 0", "1 0 0", "0 0 0"}));
}

TEST(Offsets, AreFoundFromThePositionAsRs274Does) {
  EXPECT_EQ(ends_of("G10 L2 P1 X10 Y20 R30\nG0 X1 Y2\nG92 X5\nG0 X0 Y0\nG92.1\nG0 X1 Y2\n"
                    "G10 L20 P1 X0\nG0 X0 Y0\nG0 X3\nG10 L20 P2 X1 Y1\nG55 G0 X0 Y0"),
            (Ends{"9.866 22.2321 0", "6.5359 18 0", "9.866 22.2321 0", "10.866 20.5 0",
                  "13.4641 22 0", "12.4641 21 0"}));
  EXPECT_EQ(ends_of("G92 X5\nG43 H1\nG10 L20 P1 X1 Z1\nG0 X0 Y0 Z0\nG92.1 G0 X0"),
            (Ends{"-1 0 -1", "4 0 -1"}));
  EXPECT_EQ(ends_of("G92 X5\nG10 L20 P2 X1 Y1\nG55 G0 X0 Y0\nG92.1 G0 X0"),
            (Ends{"-1 -1 0", "4 -1 0"}));
}

TEST(Offsets, OfToolsAreWrittenByG10AndTakenUpByTheNextG43) {
  EXPECT_EQ(
      ends_of("T1 M6 G43\nG0 Z0\nG10 L1 P1 Z20\nG0 Z0\nG43\nG0 Z0\nG10 L10 P1 Z5\nG43\nG0 Z0\n"
              "G10 L11 P1 Z7\nG43\nG0 Z0\nG10 L20 P1 X7\nG0 X0\nG10 L20 P2 X7 Z1\n"
              "G55 G0 X0 Z0"),
      (Ends{"0 0 12.5", "0 0 20", "0 0 15", "0 0 8", "-7 0 8", "-14 0 7"}))
      << "but for moves of zero length, which rs274 prints";
}

TEST(Offsets, WorkOffsetsReachToG59Point3) {
  EXPECT_EQ(ends_of("G10 L2 P6 X6\nG10 L2 P7 X7\nG10 L2 P9 X9\nG59 G0 X0\nG59.1 X0\nG59.2 X0\n"
                    "G59.3 X0\nG10 L2 P0 X10\nX0"),
            (Ends{"6 0 0", "7 0 0", "0 0 0", "9 0 0", "10 0 0"}));
}

TEST(Offsets, AreReadInTheUnitsOfTheProgram) {
  EXPECT_EQ(ends_of("G20\nG10 L2 P1 X1\nG0 X1\nG92 X0\nG21 X10\nG43.1 Z1\nG20 G0 Z1"),
            (Ends{"50.8 0 0", "60.8 0 0", "60.8 0 26.4"}));
}

TEST(Offsets, ComeFromTheMachine) {
  MachineData machine;
  machine.work[0] = {{1.0, 2.0, 3.0}, 90.0};
  machine.first_home_mm = {5.0, 6.0, 7.0};
  const Program program = read_program("G0 X1 Y0 Z0\nG28\nM2\n", {.machine = machine});
  EXPECT_EQ(text_of(std::get<LineMove>(program.moves.at(0).shape).end_mm), "1 3 3");
  EXPECT_EQ(text_of(std::get<LineMove>(program.moves.at(1).shape).end_mm), "5 6 7");
}

TEST(Offsets, MovesOfZeroLengthStayOnesUnderATurn) {
  EXPECT_EQ(ends_of("G10 L2 P1 X3 Y4 R33\nG0 X1 Y2 Z3\nZ3\nG91 Z0").size(), 1U);
}

TEST(Offsets, RefuseWhatNothingCanBeMadeOf) {
  EXPECT_EQ(first_message_with_table("G28 G1 X5"),
            "1:5: error: G28 and G1 both use the axis words");
  EXPECT_EQ(first_message_with_table("G92 G0 X5"),
            "1:5: error: G92 and G0 both use the axis words");
  EXPECT_EQ(first_message_with_table("G10 L2 P1 G1 X5"),
            "1:11: error: G10 and G1 both use the axis words");
  EXPECT_EQ(first_message_with_table("G92"), "1:1: error: G92 needs at least one axis word");
  EXPECT_EQ(first_message_with_table("G43.1"), "1:1: error: G43.1 needs at least one axis word");
  EXPECT_EQ(first_message_with_table("G10 P1 X0"), "1:1: error: G10 needs L");
  EXPECT_EQ(first_message_with_table("G10 L7 P1 X0"),
            "1:5: error: G10: L7 is not known (L1, L2, L10, L11, L20 are)");
  EXPECT_EQ(first_message_with_table("G10 L2 P99 X0"),
            "1:8: error: G10 L2: P must be 0 to 9, found 99");
  EXPECT_EQ(first_message_with_table("G10 L2 P1.5 X0"),
            "1:8: error: G10 L2: P must be 0 to 9, found 1.5");
  EXPECT_EQ(first_message_with_table("G10 L20 P1 R0"), "1:12: error: R is not used by G10 L20");
  EXPECT_EQ(first_message_with_table("G10 L1 P99 Z0"), "1:8: error: T99 is not in the tool table");
  EXPECT_EQ(first_message_with_table("G0 G43 H99 Z5"), "1:8: error: H99 is not in the tool table");
  EXPECT_EQ(first_message_with_table("G0 G43 H-5 Z5"), "1:8: error: H must not be negative");
  EXPECT_EQ(first_message_with_table("G0 G43 H1.5 Z5"), "1:8: error: H must be a whole number");
  EXPECT_EQ(first_message_with_table("T99 M6"), "1:1: error: T99 is not in the tool table");
  EXPECT_EQ(first_message_with_table("G43 H1 Z5"),
            "1:8: error: axis words are given but no motion mode is active (G0, G1, G2 ... is "
            "expected)");
  EXPECT_EQ(first_message_with_table("F9 G10 L2 P1 R30\nG18 G2 X2 I1"),
            "2:5: error: an arc in the XZ plane cannot be run while the work offset is turned "
            "(G10 L2 R)");
}

TEST(Offsets, NumbersThatNothingUsesAreOnlyWarnedOf) {
  EXPECT_EQ(first_message_with_table("T4 D04 M06"),
            "1:4: warning: D04 is not used in this block (D needs G41 or G42)");
  EXPECT_EQ(first_message_with_table("G0 X1 H5"),
            "1:7: warning: H5 is not used in this block (H needs G43)");
}

TEST(Offsets, WithoutATableEveryToolIsThere) {
  EXPECT_EQ(first_message("T99 M6\nG43 H99 G0 Z5\nG10 L1 P4711 Z2\nG43 H4711"), "no message");
}

}  // namespace
}  // namespace kerf::parser
