// Planning that is late where the tool comes to rest for the program: what waits there, ends there
// or dwells there still does.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

constexpr std::int64_t kLateAtRest = 900;  // ticks

// Whose ramps are phases longer than the horizon.
MachineSettings slow_mill() {
  MachineSettings slow = mill();
  slow.limits.path.acceleration_mm_s2 = 500.0;
  slow.limits.path.jerk_mm_s3 = 10'000.0;
  for (MotionLimits& axis : slow.limits.axes) {
    axis = slow.limits.path;
  }
  return slow;
}

struct Lateness {
  std::int64_t from = 0;
  bool single_block = false;
};

// Plans before each tick but where it is late, and answers what has waited for five ticks.
WatchedRun run_late(const WatchedProgram& program, const Lateness& late) {
  int waited = 0;
  return run_ticks(program, [&](Kernel& kernel, const WatchedRun& run, Setpoint& setpoint) {
    if (run.next() == 0) {
      kernel.set_single_block(late.single_block);
    }
    const bool waits = run.next() > 0 && run.statuses.back() == TickStatus::waiting;
    waited = waits ? waited + 1 : 0;
    if (run.next() < late.from || run.next() >= late.from + kLateAtRest) {
      kernel.plan();
      if (waited >= 5) {
        kernel.resume();
      }
    }
    return kernel.tick(setpoint);
  });
}

// From a hundred ticks before the ramp to X100 is handed over to its end.
template <typename Expect>
void for_each_late_run(const std::string& text, bool single_block, const Expect& expect) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    for (std::int64_t from = 410; from < 1010; from += 30) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", late from " + std::to_string(from));
      const WatchedRun run =
          run_late({.text = text,
                    .options = {.profile = {.kind = kind}, .waits = true, .asks_machine = true},
                    .settings = slow_mill()},
                   {.from = from, .single_block = single_block});
      EXPECT_EQ(run.complaint, "");
      expect(run);
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

TEST(LateAtRests, AProgramStillWaitsForItsAnswer) {
  const std::string before = "G21 G90 G61 F9000\nG1 X100\n";
  for (const std::string wait : {"M0\n", "M6 T1\n", ""}) {  // without any: single block
    for_each_late_run(before + wait + "G1 X0\nM2\n", wait.empty(), [](const WatchedRun& run) {
      const auto waits = std::ranges::find(run.statuses, TickStatus::waiting);
      ASSERT_NE(waits, run.statuses.end());
      const auto first = static_cast<std::size_t>(waits - run.statuses.begin());
      EXPECT_EQ(run.ticks[first].position_mm[0], 100.0);
      EXPECT_EQ(run.ticks[first].s_mm, 100.0);
    });
  }
}

TEST(LateAtRests, AProgramThatAsksTheMachineGoesOnBehindItsAnswer) {
  for_each_late_run("G21 G90 G61 F9000\nG1 X100\nM66 P0 L3 Q0.5\nG1 X0\nM2\n", false,
                    [](const WatchedRun& run) { EXPECT_EQ(run.ticks.back().s_mm, 200.0); });
}

TEST(LateAtRests, AProgramEndsThoughItsTextEndsWithoutACode) {
  for_each_late_run("G21 G90 G61 F9000\nG1 X100\n", false,
                    [](const WatchedRun& run) { EXPECT_EQ(run.ticks.back().s_mm, 100.0); });
}

TEST(LateAtRests, ADwellLastsAsLongAsItIs) {
  for_each_late_run(
      "G21 G90 G61 F9000\nG1 X100\nG4 P0.2\nG1 X0\nM2\n", false, [](const WatchedRun& run) {
        const auto rests =
            std::ranges::count_if(run.ticks, [](const Setpoint& at) { return at.s_mm == 100.0; });
        EXPECT_GE(rests, 200);
      });
}

// Found by reading: what was run of it was run again.
TEST(LateAtRests, ADwellIsRunOnceThoughAHoldComesRightBehind) {
  const std::string text = "G21 G90 G61 F3000\nG1 X10\nG4 P1\nG1 X0\nM2\n";
  const auto whole = ticks_of(text);
  const std::int64_t dwells = std::ranges::find(whole, 10.0, &Setpoint::s_mm)->tick;
  for (std::int64_t from = dwells + 20; from < dwells + 700; from += 40) {
    SCOPED_TRACE("late from " + std::to_string(from));
    const WatchedRun run =
        run_ticks({.text = text}, [&](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
          if (ran.next() == from + kLateAtRest) {
            kernel.hold();
          } else if (ran.next() == from + kLateAtRest + 30) {
            kernel.resume();
          } else if (ran.next() < from || ran.next() > from + kLateAtRest) {
            kernel.plan();
          }
          return kernel.tick(setpoint);
        });
    EXPECT_EQ(run.complaint, "");
    std::int64_t runs = 0;
    for (std::size_t i = 0; i < run.ticks.size(); ++i) {
      runs += run.ticks[i].s_mm == 10.0 && run.statuses[i] == TickStatus::running ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(runs), 1000.0, 3.0);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

}  // namespace
}  // namespace kerf::test
