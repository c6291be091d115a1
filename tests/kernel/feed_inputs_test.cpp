// What the machine makes of the feedrate where the program lets it: M52 and M53.
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

using InputsAt = std::map<std::int64_t, FeedInputs>;  // before each of these ticks

double fastest_mm_s(const WatchedRun& run, std::uint32_t line) {
  double most = 0.0;
  for (const Setpoint& tick : run.ticks) {
    most = tick.line == line ? std::max(most, tick.v_mm_s) : most;
  }
  return most;
}

WatchedRun run_with_inputs(const std::string& text, const InputsAt& inputs) {
  return watched_run({.text = text, .options = {.profile = {.kind = ProfileKind::time_optimal}}},
                     [&](Kernel& kernel, const WatchedRun& run) {
                       if (const auto now = inputs.find(run.next()); now != inputs.end()) {
                         EXPECT_TRUE(kernel.set_feed_inputs(now->second));
                       }
                     });
}

bool same_end(const WatchedRun& a, const WatchedRun& b) {
  return a.ticks.back().position_mm == b.ticks.back().position_mm &&
         a.ticks.back().s_mm == b.ticks.back().s_mm;
}

TEST(AdaptiveFeed, IsFollowedUnderM52Alone) {
  const std::string text = "G61 G1 X40 F3000\nM52 P1\nX80\nG0 X0\nM52 P0\nG1 X40\nM2\n";
  const WatchedRun run = run_with_inputs(text, {{0, {.adaptive = 0.5}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_NEAR(fastest_mm_s(run, 1), 50.0, 0.05);
  EXPECT_NEAR(fastest_mm_s(run, 3), 25.0, 0.05);
  EXPECT_NEAR(fastest_mm_s(run, 4), 0.5 * kFastest_mm_s, 0.1);
  EXPECT_NEAR(fastest_mm_s(run, 6), 50.0, 0.05);
}

TEST(AdaptiveFeed, MayChangeInMotion) {
  const std::string text = "G61 M52 P1\nG1 X100 F3000\nM2\n";
  const WatchedRun run = run_with_inputs(text, {{500, {.adaptive = 0.2}}, {1500, {}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_NEAR(run.ticks.at(400).v_mm_s, 50.0, 0.05);
  EXPECT_NEAR(run.ticks.at(1400).v_mm_s, 10.0, 0.05);
  EXPECT_NEAR(run.ticks.at(2200).v_mm_s, 50.0, 0.05);
}

TEST(AdaptiveFeed, Of0HoldsFromTheBlockOnThatFollowsIt) {
  const std::string text = "G61 G1 X40 F3000\nM52 P1\nX80\nM2\n";
  const WatchedRun free = run_with_inputs(text, {});
  const WatchedRun run = run_with_inputs(text, {{0, {.adaptive = 0.0}}, {3000, {.adaptive = 1.0}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_GT(run.count(TickStatus::held), 500);
  EXPECT_GE(run.first_held().position_mm[0], 40.0);
  EXPECT_LT(run.first_held().position_mm[0], 45.0);  // 50 mm/s for 10 ms, then the shortest way
  EXPECT_EQ(run.first_held().line, 3U);
  EXPECT_TRUE(same_end(run, free));
}

TEST(AdaptiveFeed, OutOfItsRangeIsRefused) {
  Kernel kernel(mill());
  EXPECT_FALSE(kernel.set_feed_inputs({.adaptive = -0.1}));
  EXPECT_FALSE(kernel.set_feed_inputs({.adaptive = 1.1}));
  EXPECT_FALSE(kernel.set_feed_inputs({.adaptive = std::nan("")}));
  EXPECT_TRUE(kernel.set_feed_inputs({.adaptive = 1.0, .stop = true}));
}

TEST(FeedStop, HoldsWhereverItComesAndIsOverWithTheInput) {
  const std::string text = mixed_program();
  const WatchedRun free = run_with_inputs(text, {});
  ASSERT_EQ(free.complaint, "");
  const auto end = static_cast<std::int64_t>(free.ticks.size());
  for (std::int64_t tick = 13; tick < end; tick += end / 23) {
    SCOPED_TRACE(tick);
    const WatchedRun run = run_with_inputs(text, {{tick, {.stop = true}}, {tick + 900, {}}});
    EXPECT_EQ(run.complaint, "");
    EXPECT_TRUE(same_end(run, free));
    if (tick + kLongestStop_ticks < end) {
      EXPECT_GT(run.count(TickStatus::held), 900 - 2 * kLongestStop_ticks);
    }
  }
}

TEST(FeedStop, LeavesTheWayUnderM53P0) {
  const std::string text = "G61 M53 P0\nG1 X40 F3000\nM53\nX80\nM2\n";
  const WatchedRun free = run_with_inputs(text, {});
  const WatchedRun run = run_with_inputs(text, {{100, {.stop = true}}, {4000, {}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_GE(run.first_held().position_mm[0], 40.0);
  EXPECT_LT(run.first_held().position_mm[0], 45.0);
  EXPECT_TRUE(same_end(run, free));
}

TEST(FeedStop, IsNoAnswerToAWaitAndLeavesTheHoldOfAnOperator) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G61 G1 X20 F3000\nM0\nX40\nM2\n");
  kernel.finish();
  const auto status_after = [&kernel](int ticks) {
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    for (int i = 0; i < ticks; ++i) {
      status = kernel.next(setpoint);
    }
    return status;
  };
  EXPECT_EQ(status_after(3000), TickStatus::waiting);
  kernel.set_feed_inputs({.stop = true});
  EXPECT_EQ(status_after(300), TickStatus::waiting);
  kernel.set_feed_inputs({});
  EXPECT_EQ(status_after(300), TickStatus::waiting);
  kernel.resume();
  EXPECT_EQ(status_after(200), TickStatus::running);
  kernel.hold();
  kernel.set_feed_inputs({.stop = true});
  EXPECT_EQ(status_after(500), TickStatus::held);
  kernel.set_feed_inputs({});
  EXPECT_EQ(status_after(500), TickStatus::held);
  kernel.resume();
  EXPECT_EQ(status_after(2000), TickStatus::finished);
}

}  // namespace
}  // namespace kerf::test
