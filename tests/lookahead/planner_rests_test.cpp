// Rests, stops and the slices in which the plan leaves.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/planner.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(Planner, CommitsLongCruisesInSlices) {
  const PlanLimits limits = mill();
  const Motion motion = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                             {.limits = limits, .longest_cruise_s = 0.1});
  expect_contiguous(motion.phases());
  EXPECT_GT(motion.phases().size(), 90U);
  for (const interp::Phase& phase : motion.phases()) {
    EXPECT_LE(phase.law.duration_s(), 0.2 + 1e-12);
  }
  const Motion whole = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                            {.limits = limits, .longest_cruise_s = 1e9});
  EXPECT_NEAR(motion.duration_s(), whole.duration_s(), 1e-9);
}

TEST(Planner, RestsForItsDurationOnTicks) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits});
  Outbox outbox;
  const auto blocks = blocks_of(straight(2, 10.0, 50.0), limits);
  planner.push(Block(blocks[0]));
  planner.push_rest(0.2505, 7);
  while (planner.emit(outbox)) {
  }
  planner.push(Block(blocks[1]));
  planner.finish(8);
  while (planner.emit(outbox)) {
  }
  expect_contiguous(outbox.phases);
  const auto rest = std::find_if(outbox.phases.begin(), outbox.phases.end(),
                                 [](const interp::Phase& phase) { return phase.line == 7; });
  ASSERT_NE(rest, outbox.phases.end());
  EXPECT_EQ(rest->begin.offset_s, 0.0);
  EXPECT_EQ(rest->law.duration_s(), 0.2505);
  EXPECT_EQ(std::next(rest)->begin.tick - rest->begin.tick, 251);
  EXPECT_EQ(rest->path_begin_mm + rest->s_end_mm, 10.0);
}

TEST(Planner, StopsOnRequestBelowThePlan) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits});
  for (Block& block : blocks_of(straight(40, 3.0, 100.0), limits)) {
    planner.push(std::move(block));
  }
  planner.finish(9);
  Outbox outbox;
  for (int i = 0; i < 15; ++i) {
    ASSERT_TRUE(planner.emit(outbox));
  }
  const interp::Phase& last = outbox.phases.back();
  const double v = last.law.ramp().v_end_mm_s;
  const double s = last.path_begin_mm + last.s_end_mm;
  ASSERT_GT(v, 50.0);
  planner.stop();
  while (planner.emit(outbox)) {
  }
  expect_contiguous(outbox.phases);
  const Motion motion(outbox.phases, kTs);
  const auto end = motion.at(motion.duration_s());
  EXPECT_EQ(end.v_mm_s, 0.0);
  // Over several short blocks, each ending with no acceleration, takes longer than one ramp, but
  // not much longer.
  const double ramp = v * (v / 2000.0 + 2000.0 / 5e4) / 2.0;
  EXPECT_GT(end.s_mm - s, 0.999 * ramp);
  EXPECT_LT(end.s_mm - s, 2.0 * ramp + 3.0);
}

// What the planner holds is bounded by its window, so the work for a block is, too: between two
// blocks that go in, only so many segments come out.
TEST(Planner, EmitsNoMoreAtOnceThanItsWindowHolds) {
  const PlanLimits limits = mill();
  const std::size_t window = 50;
  Planner planner({.limits = limits, .window_blocks = window});
  Outbox outbox;
  std::size_t held = 0;
  for (Block& block : blocks_of(polyline(3000, 100.0, 50.0), limits)) {
    while (!planner.wants_block()) {
      ASSERT_TRUE(planner.emit(outbox));
    }
    planner.push(std::move(block));
    ++held;
    const std::size_t begun = outbox.pieces.size();
    ASSERT_LE(held - begun, window);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
