#include "programs/kerf/page/motion_runs.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(MotionRuns, EndWhereLineKindOrToolChange) {
  MotionRuns runs;
  auto add = [&runs, tick = std::int64_t{0}](const TickRecord& record) mutable {
    for (int i = 0; i < 10; ++i) {
      TickRecord at = record;
      at.tick = tick++;
      runs.add(at);
    }
  };
  add({.line = 3, .rapid = true, .limit = Constraint::path_jerk});
  add({.line = 3, .rapid = true, .limit = Constraint::rest});
  add({.line = 3, .tool = 4, .limit = Constraint::rest});
  add({.line = 5, .tool = 4, .limit = Constraint::programmed});
  add({.line = 5, .tool = 4, .limit = Constraint::chord_error});
  ASSERT_EQ(runs.runs().size(), 4U);
  EXPECT_EQ(runs.runs()[0].kind, TickKind::rapid);
  EXPECT_EQ(runs.runs()[1].kind, TickKind::rest);
  EXPECT_EQ(runs.runs()[2].tool, 4);
  EXPECT_EQ(runs.runs()[3].kind, TickKind::cut);
  EXPECT_EQ(runs.runs()[3].tick, 30);
  EXPECT_EQ(runs.shortest_ticks(), 1);
}

TEST(MotionRuns, JoinTheShortestWhereThereAreTooMany) {
  MotionRuns runs(100);
  for (std::int64_t tick = 0; tick < 10'000; ++tick) {
    // A line of a tick each, but for line 7000, which takes a thousand.
    const bool is_long = tick >= 7000 && tick < 8000;
    runs.add({.tick = tick,
              .line = static_cast<std::uint32_t>(is_long ? 7000 : tick),
              .limit = Constraint::programmed});
  }
  EXPECT_LE(runs.runs().size(), 100U);
  EXPECT_GT(runs.runs().size(), 25U);
  EXPECT_GT(runs.shortest_ticks(), 1);
  EXPECT_LE(runs.shortest_ticks(), 10'000 / 25);
  EXPECT_EQ(runs.runs().front().tick, 0);
  bool found = false;
  for (const LineRun& run : runs.runs()) {
    found = found || (run.line == 7000 && run.tick == 7000);
  }
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace kerf::program
