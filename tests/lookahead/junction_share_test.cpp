// How the time optimum passes junctions: as fast as the jump allows, and no slower for one that
// hardly counts.
#include "lookahead/optimum/grid/junction_share.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

double duration_s(const std::vector<parser::Move>& moves, ProfileKind kind) {
  const PlanLimits limits = mill();
  const Motion motion =
      plan(blocks_of(moves, limits), {.limits = limits, .profile = Profile{kind}});
  return motion.duration_s();
}

// Onto an arc of 2 m radius 0.75 v^2 / (R Ts) is an eighth of the jerk at 130 mm/s, so the motion
// is nearly that over the straight line of the same length, whose time is known: V and A are
// reached, L / V + V / A + A / J.
TEST(JunctionShare, AMildJunctionIsPassedWhileTheToolSpeedsUp) {
  const double radius = 2000.0;
  const double angle = 0.03;
  const Position end{4.0 + radius * std::sin(angle), radius * (1.0 - std::cos(angle)), 0.0};
  const std::vector<parser::Move> moves{
      line_move({{0, 0, 0}, {4, 0, 0}}, 130.0),
      arc_move({.ends = {{4, 0, 0}, end}, .centre = {4, radius, 0}}, 130.0)};
  const double length = 4.0 + radius * angle;
  const double straight = length / 130.0 + 130.0 / 2000.0 + 2000.0 / 5e4;
  const double time = duration_s(moves, ProfileKind::time_optimal);
  EXPECT_GE(time, 0.999 * straight);
  EXPECT_LE(time, 1.02 * straight);
}

// Every junction of a polygon is a hard one. The S-curve plans such a row of lines between given
// feedrates, which is optimal there.
TEST(JunctionShare, ARowOfHardJunctionsIsNoSlowerThanByTheSCurve) {
  for (const double radius : {5.0, 20.0, 60.0}) {
    const auto moves = polyline(120, radius, 60.0);
    EXPECT_LE(duration_s(moves, ProfileKind::time_optimal),
              duration_s(moves, ProfileKind::s_curve) + kTs)
        << radius;
  }
}

// A turn of 0.01 rad takes all of the jerk at J Ts^2 / 0.01 = 5 mm/s; up to half of it the motion
// may go on over it.
TEST(JunctionShare, AJunctionThatTakesMoreThanHalfOfTheJerkIsPassedAsACruise) {
  const PlanLimits limits = mill();
  const auto blocks = blocks_of(
      {line_move({{0, 0, 0}, {5, 0, 0}}, 60.0), line_move({{5, 0, 0}, {10, 0.05, 0}}, 60.0)},
      limits);
  ASSERT_EQ(blocks.size(), 2U);
  const JunctionQuery query{.before = &blocks[0], .after = &blocks[1]};
  EXPECT_NEAR(junction_of(query, limits).feedrate_mm_s, 5.0, 0.01);
  EXPECT_TRUE(passed_as_cruise(query, 5.0, limits));
  EXPECT_TRUE(passed_as_cruise(query, 2.6, limits));
  EXPECT_FALSE(passed_as_cruise(query, 2.4, limits));
}

// A jump within a curve: from an arc of 5 mm to one of 8 mm.
Jump bend() {
  Jump jump;
  jump.before.second_per_mm = {0.0, 0.2, 0.0};
  jump.after.second_per_mm = {0.0, 0.125, 0.0};
  return jump;
}

// 3/4 |dk| v^2 / Ts of an axis, whatever v will be: 56.25 v^2 of 50000.
TEST(JunctionShare, AJumpOfCurvatureTakesOfTheJerkWhatItNeedsAtEachFeedrate) {
  Jump jump = bend();
  for (const double allowed : {20.0, 25.0, 1e3}) {
    jump.allowed_mm_s = allowed;
    const JunctionLimits junction = junction_limits_of(jump, mill());
    const double of_jump = junction.jumps_per_mm_s[1];
    EXPECT_NEAR(of_jump, 0.75 * 0.075 / kTs, 1e-9 * of_jump);
    EXPECT_EQ(junction.jumps_per_mm_s[0], 0.0);
    const double v = junction.feedrate_mm_s;
    EXPECT_LE(v, allowed);
    EXPECT_LE(of_jump * v * v, 5e4);
    EXPECT_TRUE(v == allowed || of_jump * v * v > 0.99 * 5e4) << "as fast as the jump alone allows";
    EXPECT_GT(junction.shares.cells, 0.95);
  }
}

// Where the feedrate may double within a tick, the tick of the jump is no measure of those beside
// it: the jump and the cells have fixed shares.
TEST(JunctionShare, WhatASlowJumpAsksForFitsIntoItsShare) {
  Jump jump = bend();
  for (const double allowed : {0.1, 1.0, 3.0}) {
    for (const int crowd : {1, 3}) {
      jump.allowed_mm_s = allowed;
      jump.crowd = crowd;
      const JunctionLimits junction = junction_limits_of(jump, mill());
      const double v = junction.feedrate_mm_s;
      EXPECT_EQ(junction.jumps_per_mm_s[1], 0.0);
      EXPECT_LE(v, allowed);
      EXPECT_LE(crowd * 0.75 * 0.075 * v * v / kTs, junction.shares.jump * 5e4 * (1.0 + 1e-9));
      EXPECT_LT(junction.shares.jump + junction.shares.turn + junction.shares.cells, 1.0);
    }
  }
}

// What rounding to four decimals leaves of a tangent is no corner.
TEST(JunctionShare, ASlightTurnBesideAJumpOfCurvatureIsLeftFree) {
  Jump jump = bend();
  jump.allowed_mm_s = 25.0;
  jump.before.first = {1.0, 0.0, 0.0};
  jump.after.first = {1.0, 1e-5, 0.0};
  const JunctionLimits junction = junction_limits_of(jump, mill());
  EXPECT_GT(junction.jumps_per_mm_s[1], 0.0);
  // v |du| / Ts^2 = 250 of 50000
  EXPECT_LT(junction.shares.cells, 0.998 - 250.0 / 5e4);
  jump.after.first = {std::cos(1e-2), std::sin(1e-2), 0.0};
  EXPECT_EQ(junction_limits_of(jump, mill()).jumps_per_mm_s[1], 0.0);
}

// A rest at a junction passes no jump: the cells beside it have all of the limits again, and share
// them again once it is passed in motion.
TEST(JunctionShare, CellsBesideARestHaveAllOfTheLimits) {
  std::vector<Cell> cells(4, Cell{.length_mm = 1e-3, .along = {2000.0, 5e4}});
  const std::vector<Cell> free = cells;
  share_limits(cells, cells.size(),
               {.feedrate_mm_s = 1.0, .shares = {.cells = 0.02, .tangential = 0.02}}, mill());
  EXPECT_EQ(cells.back().allowed.jerk, 0.02);
  const std::vector<Cell> shared = cells;
  relax_beside_rest(cells, BlockSide::end);
  for (const Cell& cell : cells) {
    EXPECT_EQ(cell.allowed.jerk, 1.0);
    EXPECT_EQ(cell.along.acceleration_mm_s2, 2000.0);
    EXPECT_EQ(cell.shares.jerk, kAim);
  }
  for (Cell& cell : cells) {
    bind_beside_junction(cell);
  }
  EXPECT_EQ(cells.back().allowed.jerk, 0.02);
  EXPECT_EQ(cells.back().along.acceleration_mm_s2, shared.back().along.acceleration_mm_s2);
}

}  // namespace
}  // namespace kerf::lookahead::test
