// Planning that is late or ends: the tool comes to rest on the path, and goes on once there is a
// plan again.
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

constexpr std::int64_t kLate = 900;  // ticks: the horizon, the way to rest and a rest after it

// Calls plan() before each tick but those from late_from on.
WatchedRun run_late(const std::string& text, const KernelOptions& options, std::int64_t late_from) {
  return run_ticks({.text = text, .options = options},
                   [&](Kernel& kernel, const WatchedRun& run, Setpoint& setpoint) {
                     if (run.next() < late_from || run.next() >= late_from + kLate) {
                       kernel.plan();
                     }
                     return kernel.tick(setpoint);
                   });
}

TEST(LatePlanning, IsARestOnThePathWithinTheLimitsWhereverItBegins) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(mixed_program(), options);
    for (std::int64_t tick = 1; tick + 300 < whole.back().tick; tick += 61) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick));
      const WatchedRun run = run_late(mixed_program(), options, tick);
      expect_whole(run, whole);
      EXPECT_GT(run.count(TickStatus::starved), 0);
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

// 5,000 lines of 0.02 mm, straight on: a way to rest from 200 mm/s goes over 700 of them.
std::string dense_program() {
  std::string text = "G21 G90 G61 F12000\nG1 X20\n";
  for (int i = 1; i <= 5000; ++i) {
    text += "X" + std::to_string(20.0 + 0.02 * i) + "\n";
  }
  return text + "M2\n";
}

TEST(LatePlanning, OnLinesOfLessThanATickIsOneRest) {
  const auto whole = ticks_of(dense_program());
  for (std::int64_t tick = 100; tick + 300 < whole.back().tick; tick += 150) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    const WatchedRun run = run_late(dense_program(), {}, tick);
    expect_whole(run, whole);
    EXPECT_GT(run.count(TickStatus::starved), 0);
    // After a rest it takes as long again to the end, and kLate while nothing was planned.
    EXPECT_LT(run.ticks.back().tick, whole.back().tick + kLate + 300);
  }
}

// Found with a client: ticks go on within the searches for plans that are to take over, which come
// too late then. What they left behind was forgotten, and the plan that stayed in force could not
// be taken up again.
TEST(LatePlanning, OfAPlanThatIsToTakeOverLeavesTheOneBeforeAsItWas) {
  constexpr std::int64_t kCommands = 2500;  // calls
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto one_of = [&](int count) { return static_cast<int>(random() >> 1U) % count; };
    Kernel* ticked = nullptr;
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    TickChecker checker(mill().limits, true);
    KernelOptions options;
    options.plan_log = [&](std::string_view line) {
      for (int i = 5 + one_of(55); ticked != nullptr && i > 0 && line.starts_with("search over");
           --i) {
        status = ticked->tick(setpoint);
        checker.add({.setpoint = setpoint, .feedrate_mm_s = 2.0 * kFastest_mm_s});
      }
    };
    Kernel kernel(mill(), options);
    kernel.feed(dense_program());
    kernel.finish();
    bool single = false;
    std::int64_t next = 30;
    for (std::int64_t call = 0;
         call < kMaxTicks && status != TickStatus::finished && status != TickStatus::failed;
         ++call) {
      kernel.plan();
      ticked = &kernel;
      if (call == next && call < kCommands) {
        next += 15 + one_of(40);
        const int what = one_of(5);
        if (what < 2) {
          kernel.set_overrides({.feed = 0.1 + 0.2 * one_of(7)});
        } else if (what == 2) {
          kernel.set_single_block(single = !single);
        } else {
          what == 3 ? kernel.hold() : kernel.resume();
        }
      } else if (call >= kCommands && call % 100 == 0) {
        kernel.set_single_block(false);
        kernel.resume();
      }
      status = kernel.tick(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = 2.0 * kFastest_mm_s});
    }
    ASSERT_EQ(complaint_at_end(status, checker, kernel), "");
    EXPECT_EQ(setpoint.position_mm[0], 120.0);
  }
}

// Found with a client: a ramp of one phase that is longer than the horizon got on by a tick at each
// call, then rested.
TEST(LatePlanning, OfSomeTimesAHorizonIsEnoughForARampThatIsLongerThanIt) {
  MachineSettings slow = mill();
  slow.limits.path.acceleration_mm_s2 = 500.0;
  slow.limits.path.jerk_mm_s3 = 10'000.0;
  for (MotionLimits& axis : slow.limits.axes) {
    axis = slow.limits.path;
  }
  const std::string text = "G21 G90 G61\nG1 X100 F9000\nM2\n";
  for (const ProfileKind kind :
       {ProfileKind::time_optimal, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic}) {
    for (const std::int64_t each : {1, 2, 10, 25}) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", plan() each " + std::to_string(each));
      const WatchedProgram program{
          .text = text, .options = {.profile = {.kind = kind}}, .settings = slow};
      const WatchedRun whole = watched_run(program, [](Kernel&, const WatchedRun&) {});
      const WatchedRun run =
          run_ticks(program, [each](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
            if (ran.next() % each == 0) {
              kernel.plan();
            }
            return kernel.tick(setpoint);
          });
      ASSERT_EQ(run.complaint, "");
      EXPECT_EQ(run.count(TickStatus::starved), 0);
      EXPECT_EQ(run.next(), whole.next());
    }
  }
}

TEST(LatePlanning, ThatIsNeverLateChangesNoTick) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto one = ticks_of(mixed_program(), options);
    const WatchedRun run = run_late(mixed_program(), options, kMaxTicks);
    ASSERT_EQ(run.ticks.size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      ASSERT_EQ(run.ticks[i].position_mm, one[i].position_mm) << "tick " << i;
    }
  }
}

TEST(LatePlanning, LeavesAHoldThatWasAskedForBeforeToBeTaken) {
  const auto whole = ticks_of(mixed_program());
  for (std::int64_t hold = 100; hold < whole.back().tick; hold += 307) {
    SCOPED_TRACE("tick " + std::to_string(hold));
    Kernel kernel(mill());
    kernel.feed(mixed_program());
    kernel.finish();
    TickChecker checker(mill().limits, true);
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    for (std::int64_t tick = 0; tick < hold + kLate && status != TickStatus::finished; ++tick) {
      if (tick < hold) {
        kernel.plan();
      } else if (tick == hold) {
        kernel.hold();
      }
      status = kernel.tick(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
    }
    EXPECT_TRUE(status == TickStatus::held || status == TickStatus::finished);
    EXPECT_EQ(checker.complaint(), "");
  }
}

// Nobody says that it is late, and planning goes on.
TEST(LatePlanning, AndLateTextAreARestWithinTheLimits) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    SCOPED_TRACE(name_of(kind));
    Kernel kernel(mill(), {.profile = {.kind = kind}, .window_blocks = 20});
    std::string text = "G21 G90 F6000\n";
    for (int i = 1; i <= 100; ++i) {
      text += "G1 X" + std::to_string(5 * i) + " Y" + std::to_string(i % 2) + "\n";
    }
    kernel.feed(text);
    TickChecker checker(mill().limits, true);
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    const auto tick = [&] {
      kernel.plan();
      status = kernel.tick(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
    };
    for (int starved = 0; starved < 50;) {
      tick();
      starved += status == TickStatus::starved ? 1 : 0;
    }
    EXPECT_GT(setpoint.position_mm[0], 100.0);
    EXPECT_LT(setpoint.position_mm[0], 500.0);
    kernel.feed("M2\n");
    kernel.finish();
    while (status != TickStatus::finished && setpoint.tick < kMaxTicks) {
      tick();
    }
    EXPECT_EQ(setpoint.position_mm[0], 500.0);
    EXPECT_EQ(checker.complaint(), "");
    EXPECT_FALSE(kernel.fault());
  }
}

}  // namespace
}  // namespace kerf::test
