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

// A jump within a curve: from an arc of 5 mm to one of 8 mm.
TEST(JunctionShare, WhatAJumpAsksForFitsIntoItsShare) {
  const PlanLimits limits = mill();
  Jump jump;
  jump.before.second_per_mm = {0.0, 0.2, 0.0};
  jump.after.second_per_mm = {0.0, 0.125, 0.0};
  for (const double allowed : {1.0, 10.0, 30.0, 1e3}) {
    for (const int crowd : {1, 3}) {
      jump.allowed_mm_s = allowed;
      jump.crowd = crowd;
      const JunctionLimits junction = junction_limits_of(jump, limits);
      const double v = junction.feedrate_mm_s;
      EXPECT_LE(v, allowed);
      EXPECT_LE(crowd * 0.75 * 0.075 * v * v / kTs, junction.shares.jump * 5e4 * (1.0 + 1e-9));
      EXPECT_LT(junction.shares.jump + junction.shares.turn + junction.shares.cells, 1.0);
      const bool binds = v < allowed;
      EXPECT_TRUE(!binds || junction.shares.jump > 0.9) << "what binds has nearly all";
    }
  }
  // At 10 mm/s it takes 5625 of 50000: a ninth.
  jump.allowed_mm_s = 10.0;
  jump.crowd = 1;
  EXPECT_GT(junction_limits_of(jump, limits).shares.cells, 0.5);
}

}  // namespace
}  // namespace kerf::lookahead::test
