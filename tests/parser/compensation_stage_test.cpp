// The stage by itself, on contours in mm. End points are closed forms or what LinuxCNC 2.9 answers.
#include <gtest/gtest.h>

#include "contour.hpp"
#include "diagnostics/errors/pages.hpp"

namespace kerf::parser {
namespace {

constexpr CompensationStart kLeft{CutterSide::left, 5.0};
constexpr CompensationStart kRight{CutterSide::right, 5.0};

const diagnostics::ErrorPage* first_page(const Compensated& result) {
  return result.diagnostics.empty() ? nullptr : result.diagnostics.front().page;
}

TEST(CompensationStage, RollsAboutOutsideCorners) {
  Contour square;
  square.line(10, 0).line(10, 50).line(60, 50).line(60, 20).line(90, -20);
  EXPECT_EQ(text_of(compensated(square, kLeft)),
            "1: line to 5 5 0 feed 10\n"
            "2: line to 5 50 0 feed 10\n"
            "3: clockwise in xy about 10 50 0 to 10 55 0 turns 1 feed 10\n"
            "3: line to 60 55 0 feed 10\n"
            "4: clockwise in xy about 60 50 0 to 65 50 0 turns 1 feed 10\n"
            "4: line to 65 20 0 feed 10\n"
            "5: line to 90 -20 0 feed 10\n");
}

TEST(CompensationStage, StaysAwayFromInsideCorners) {
  Contour square;
  square.line(10, 0).line(10, 50).line(60, 50).line(60, 20).line(40, 10);
  EXPECT_EQ(text_of(compensated(square, kRight)),
            "1: line to 10 -5 0 feed 10\n"
            "2: counterclockwise in xy about 10 0 0 to 15 0 0 turns 1 feed 10\n"
            "2: line to 15 45 0 feed 10\n"
            "3: line to 55 45 0 feed 10\n"
            "4: line to 55 20 0 feed 10\n"
            "5: line to 40 10 0 feed 10\n");
}

TEST(CompensationStage, CutsLinesAndArcsBackToWhereTheirOffsetsMeet) {
  Contour arches;
  arches.line(10, 0).line(30, 0).arc({70, 0, 50, 0, true}).line(100, 0);
  arches.arc({140, 0, 120, 0, true}).arc({180, 0, 160, 0, true}).line(200, 0).line(220, 0);
  EXPECT_EQ(text_of(compensated(arches, kLeft)),
            "1: line to 10 5 0 feed 10\n"
            "2: line to 25.505102572 5 0 feed 10\n"
            "3: clockwise in xy about 50 0 0 to 74.494897428 5 0 turns 1 feed 10\n"
            "4: line to 95.505102572 5 0 feed 10\n"
            "5: clockwise in xy about 120 0 0 to 140 15 0 turns 1 feed 10\n"
            "6: clockwise in xy about 160 0 0 to 184.494897428 5 0 turns 1 feed 10\n"
            "7: line to 200 5 0 feed 10\n"
            "8: line to 220 0 0 feed 10\n");
}

TEST(CompensationStage, GoesStraightBackRoundTheEndOfALine) {
  Contour blade;
  blade.line(10, 0).line(30, 0).line(10, 0).line(10, -20);
  EXPECT_EQ(text_of(compensated(blade, kLeft)),
            "1: line to 10 5 0 feed 10\n"
            "2: line to 30 5 0 feed 10\n"
            "3: clockwise in xy about 30 0 0 to 30 -5 0 turns 1 feed 10\n"
            "3: line to 10 -5 0 feed 10\n"
            "4: line to 10 -20 0 feed 10\n");
}

TEST(CompensationStage, KeepsWholeTurns) {
  Contour hole({20, 30, 0});
  hole.line(-5, 30).line(-5, 5).arc({20, -20, 20, 5}).arc({20, -20, 20, 5, false, 2});
  hole.arc({20, -20, 20, 30, false, 1}).line(20, 30);
  const Compensated result = compensated(hole, kLeft);
  EXPECT_EQ(text_of(result.moves.at(2)),
            "3: counterclockwise in xy about 20 5 0 to 20 -15 0 turns 1 feed 10");
  EXPECT_EQ(text_of(result.moves.at(3)),
            "4: counterclockwise in xy about 20 5 0 to 20 -15 0 turns 2 feed 10");
  EXPECT_EQ(text_of(result.moves.at(4)),
            "5: counterclockwise in xy about 20 30 0 to 20 -15 0 turns 1 feed 10");
}

TEST(CompensationStage, KeepsPlungesAndDwellsAtTheCornerWhereTheyWere) {
  Contour steps;
  steps.line(10, 0).plunge(-5).dwell().line(10, 50).plunge(-7).dwell().line(60, 50).plunge(5);
  steps.line(60, 90);
  EXPECT_EQ(text_of(compensated(steps, kLeft)),
            "1: line to 5 5 0 feed 10\n"
            "2: line to 5 5 -5 feed 10\n"
            "3: dwell 1\n"
            "4: line to 5 50 -5 feed 10\n"
            "5: line to 5 50 -7 feed 10\n"
            "6: dwell 1\n"
            "7: clockwise in xy about 10 50 -7 to 10 55 -7 turns 1 feed 10\n"
            "7: line to 60 55 -7 feed 10\n"
            "8: line to 60 55 5 feed 10\n"
            "9: line to 60 90 5 feed 10\n");
}

TEST(CompensationStage, WorksInTheLathePlane) {
  Contour steps;
  steps.to({20, 0, 0}, false).to({50, 0, 0}, false).to({50, 0, 20}, false);
  steps.to({100, 0, 20}, false).to({160, 0, 20}, false);
  EXPECT_EQ(text_of(compensated(steps, {CutterSide::left, 5.0, Plane::zx})),
            "1: line to 20 0 -5 feed 10\n"
            "2: line to 50 0 -5 feed 10\n"
            "3: clockwise in zx about 50 0 0 to 55 0 0 turns 1 feed 10\n"
            "3: line to 55 0 15 feed 10\n"
            "4: line to 100 0 15 feed 10\n"
            "5: line to 160 0 20 feed 10\n");
}

// End points by LinuxCNC: `G18 G41.1 D10 L<n> G1 X20`.
TEST(CompensationStage, ShiftsTheTipOfATurningTool) {
  constexpr Point kEnds[] = {{20, 0, -5}, {15, 0, 0},  {15, 0, -10}, {25, 0, -10}, {25, 0, 0},
                             {20, 0, 0},  {15, 0, -5}, {20, 0, -10}, {25, 0, -5},  {20, 0, -5}};
  for (int orientation = 0; orientation < 10; ++orientation) {
    Contour face;
    face.to({20, 0, 0}, false).to({50, 0, 0}, false).to({60, 0, 0}, false);
    const Compensated result = compensated(face, {CutterSide::left, 5.0, Plane::zx, orientation});
    EXPECT_EQ(text_of(std::get<LineMove>(result.moves.at(0).shape).end_mm),
              text_of(kEnds[orientation]))
        << orientation;
    EXPECT_EQ(text_of(std::get<LineMove>(result.moves.at(2).shape).end_mm), "60 0 0");
  }
}

TEST(CompensationStage, RefusesWhatTheToolCannotReach) {
  Contour narrow_end;
  narrow_end.line(20, 0).line(50, 0).line(50, 3).line(20, 3).line(0, 3);
  const Compensated result = compensated(narrow_end, kLeft);
  EXPECT_EQ(first_page(result), &errors::kCompensationMoveTooShort);
  EXPECT_EQ(result.diagnostics.size(), 1U);
  EXPECT_EQ(result.diagnostics.front().source.line, 3U);
  EXPECT_EQ(result.diagnostics.front().message,
            "the tool (radius 5.000 mm) cannot reach line 3 without gouging: its path beside this "
            "move is 3.000 mm long, the inside corners at its ends take 5.000 mm");

  Contour bevel;  // 4.243 mm long, both its corners take 2.071 mm
  bevel.line(20, 0).line(50, 0).line(53, 3).line(53, 50).line(20, 60);
  EXPECT_FALSE(compensated(bevel, kLeft).refused());
  Contour shorter;
  shorter.line(20, 0).line(50, 0).line(52.9, 2.9).line(52.9, 50).line(20, 60);
  EXPECT_EQ(first_page(compensated(shorter, kLeft)), &errors::kCompensationMoveTooShort);

  Contour fillet;
  fillet.line(20, 0).line(50, 0).arc({55, 5, 50, 5}).line(55, 40).line(0, 40);
  EXPECT_EQ(first_page(compensated(fillet, kLeft)), &errors::kCompensationArcTooSmall);
  EXPECT_FALSE(compensated(fillet, {CutterSide::left, 4.999}).refused());
  EXPECT_FALSE(compensated(fillet, kRight).refused());
}

TEST(CompensationStage, LooksAheadOverSeveralMoves) {
  Contour slot;  // 8 mm wide, its end far wider
  slot.line(20, 0).line(50, 0).line(50, -20).line(70, -20).line(70, 28).line(50, 28);
  slot.line(50, 8).line(20, 8).line(0, 30);
  const Compensated result = compensated(slot, kLeft);
  EXPECT_EQ(first_page(result), &errors::kCompensationGouge);
  EXPECT_FALSE(compensated(slot, {CutterSide::left, 4.0}).refused());
}

TEST(CompensationStage, DoesNotCompareOtherDepthsOrAcrossRapids) {
  Contour level;
  level.line(20, 0).line(50, 0).line(50, -20).line(70, -20).line(70, 28).line(50, 28);
  level.plunge(5).line(50, 8).line(20, 8).line(0, 30);
  EXPECT_FALSE(compensated(level, kLeft).refused());
  Contour hop;
  hop.line(20, 0).line(50, 0).line(50, -20).line(70, -20).line(70, 28).rapid(50, 28);
  hop.line(50, 8).line(20, 8).line(0, 30);
  EXPECT_FALSE(compensated(hop, kLeft).refused());
}

TEST(CompensationStage, NeedsAStraightEntryLongerThanTheRadius) {
  Contour short_entry;
  short_entry.line(5, 0).line(5, 50).line(0, 80);
  EXPECT_EQ(first_page(compensated(short_entry, kLeft)), &errors::kCompensationEntryTooShort);
  Contour arc_entry;
  arc_entry.arc({20, 0, 10, 0}).line(50, 0).line(50, 30);
  EXPECT_EQ(first_page(compensated(arc_entry, kLeft)), &errors::kCompensationStartedOnArc);
  Contour arc_exit;
  arc_exit.line(20, 0).line(50, 0).arc({70, 0, 60, 0});
  EXPECT_EQ(first_page(compensated(arc_exit, kLeft)), &errors::kCompensationExitOnArc);
}

TEST(CompensationStage, WarnsOfASeamInAnInsideCorner) {
  Contour pocket({30, 30, 0});
  pocket.line(10, 10).line(60, 10).line(60, 60).line(10, 60).line(10, 10).line(30, 30);
  const Compensated result = compensated(pocket, kLeft);
  EXPECT_FALSE(result.refused());
  EXPECT_EQ(first_page(result), &errors::kCompensationSeam);
}

TEST(CompensationStage, LetsLeadInsAndLeadOutsBeCrossed) {
  Contour bore({50, 50, 0});
  bore.line(60, 40).arc({70, 50, 60, 50}).arc({70, 50, 50, 50}).arc({60, 60, 60, 50}).line(50, 50);
  EXPECT_TRUE(compensated(bore, kLeft).diagnostics.empty());
  Contour pocket({30, 30, 0});  // by two moves each
  pocket.line(40, 40).line(40, 20).arc({30, 10, 30, 20, true}).line(10, 10).line(10, 60);
  pocket.line(60, 60).line(60, 10).line(30, 10).arc({20, 20, 30, 20, true}).line(20, 40);
  pocket.line(30, 30);
  EXPECT_EQ(text_of(compensated(pocket, kRight)).find("cut"), std::string::npos);
  Contour overrun({-20, -20, 0});
  overrun.line(0, 0).line(-10, 17).line(0, 34).line(20, 34).line(30, 17).line(20, 0).line(-5, 0);
  overrun.line(-20, -20);
  EXPECT_TRUE(compensated(overrun, kLeft).diagnostics.empty());
}

}  // namespace
}  // namespace kerf::parser
