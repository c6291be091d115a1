// Rests, stops and the slices in which the plan leaves.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "lookahead/planner.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(Planner, CommitsLongCruisesInSlices) {
  const PlanLimits limits = mill();
  const Motion motion = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                             {.limits = limits, .longest_phase_s = 0.1});
  expect_contiguous(motion.phases());
  EXPECT_GT(motion.phases().size(), 90U);
  for (const interp::Phase& phase : motion.phases()) {
    EXPECT_LE(phase.law.duration_s(), 0.2 + 1e-12);
  }
  const Motion whole = plan(blocks_of({line_move({{0, 0, 0}, {500, 0, 0}}, 50.0)}, limits),
                            {.limits = limits, .longest_phase_s = 1e9});
  EXPECT_NEAR(motion.duration_s(), whole.duration_s(), 1e-9);
}

// Found by reading: the rounding of 16,000 slices had the last ramp end where the block does, short
// of its own length, which was seen as a jerk above the limit at the end of 90 m.
TEST(Planner, EndsALongCruiseWhereTheRampBehindItBegins) {
  constexpr double kLength_mm = 90'000.0;
  const PlanLimits limits = mill();
  const Motion motion = plan(blocks_of({line_move({{0, 0, 0}, {kLength_mm, 0, 0}}, 55.0)}, limits),
                             {.limits = limits, .longest_phase_s = 0.1});
  double s_mm = 0.0;
  double worst_mm = 0.0;
  for (const interp::Phase& phase : motion.phases()) {
    worst_mm = std::max(worst_mm, std::abs(phase.s_end_mm - s_mm - phase.law.length_mm()));
    s_mm = phase.s_end_mm;
  }
  EXPECT_EQ(s_mm, kLength_mm);
  EXPECT_LE(worst_mm, 4.0 * kLength_mm * std::numeric_limits<double>::epsilon());
}

TEST(Planner, RestsForItsDurationOnTicks) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits});
  Outbox outbox;
  const auto blocks = blocks_of(straight(2, 10.0, 50.0), limits);
  planner.push(Block(blocks[0]));
  planner.push_rest(0.2505, {.line = 7});
  while (planner.emit(outbox)) {
  }
  planner.push(Block(blocks[1]));
  planner.finish(8);
  while (planner.emit(outbox)) {
  }
  expect_contiguous(outbox.phases);
  const auto is_rest = [](const interp::Phase& phase) { return phase.line == 7; };
  const auto rest = std::find_if(outbox.phases.begin(), outbox.phases.end(), is_rest);
  const auto after = std::find_if_not(rest, outbox.phases.end(), is_rest);
  ASSERT_NE(after, outbox.phases.end());
  EXPECT_EQ(rest->begin.offset_s, 0.0);
  EXPECT_EQ(after->begin.offset_s, 0.0);
  EXPECT_EQ(after->begin.tick - rest->begin.tick, 251);
  double rest_s = 0.0;
  for (auto part = rest; part != after; ++part) {
    EXPECT_LE(part->law.duration_s(), 0.2 + 1e-12);
    EXPECT_EQ(part->path_begin_mm + part->s_end_mm, 10.0);
    rest_s += part->law.duration_s();
  }
  EXPECT_NEAR(rest_s, 0.2505, 1e-12);
}

TEST(Planner, KeepsTheTicksOfADwellThatLeavesInManyParts) {
  // The next whole tick after so many periods.
  for (const auto& [dwell_s, ticks] :
       {std::pair{1e5, std::int64_t{100'000'000}}, std::pair{644.307, std::int64_t{644'307}},
        std::pair{0.3000005, std::int64_t{301}}}) {
    Planner planner({.limits = mill()});
    Outbox outbox;
    planner.push_rest(dwell_s, {.line = 7});
    while (planner.emit(outbox)) {
      outbox.clear();
    }
    EXPECT_EQ(planner.totals().ticks, ticks) << dwell_s;
  }
}

// Over several short blocks the way is not much longer than one ramp.
TEST(Planner, HoldsFromTheMotionThatItsPlanHasAtTheTick) {
  const PlanLimits limits = mill();
  Planner planner({.limits = limits, .may_hold = true});
  for (Block& block : blocks_of(straight(40, 3.0, 100.0), limits)) {
    planner.push(std::move(block));
  }
  planner.finish(9);
  Outbox outbox;
  for (int i = 0; i < 15; ++i) {
    ASSERT_TRUE(planner.emit(outbox));
  }
  const Motion before(outbox.phases, kTs);
  Outbox hold;
  ASSERT_TRUE(planner.hold({.tick = outbox.phases.back().begin.tick - 20}, hold));
  planner.settle(true);
  expect_contiguous(hold.phases);
  const Motion motion(hold.phases, kTs);
  const double begin_s = motion.begin_s(hold.phases.front());
  const profiles::PathMotion begin = motion.at(begin_s);
  const profiles::PathMotion there = before.at(begin_s);
  const double v = there.v_mm_s;
  ASSERT_GT(v, 50.0);
  EXPECT_NEAR(begin.s_mm, there.s_mm, 1e-9);
  EXPECT_NEAR(begin.v_mm_s, v, 1e-9);
  EXPECT_NEAR(begin.a_mm_s2, there.a_mm_s2, 1e-6);
  const auto end = motion.at(motion.duration_s());
  EXPECT_TRUE(hold.phases.back().ends_at_rest);
  EXPECT_NEAR(end.v_mm_s, 0.0, 1e-9);
  const double ramp = v * (v / 2000.0 + 2000.0 / 5e4) / 2.0;
  EXPECT_GT(end.s_mm - begin.s_mm, 0.999 * ramp);
  EXPECT_LT(end.s_mm - begin.s_mm, 1.1 * ramp);
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
