// A stop on request, at any tick of a program of every kind of motion.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

struct Stopped {
  std::int64_t ticks_after = 0;
  Setpoint last{};
  std::string complaint;
};

Stopped stop_at(std::int64_t tick, ProfileKind kind, std::size_t window) {
  Kernel kernel(mill(), {.profile = Profile{kind}, .window_blocks = window});
  kernel.feed(mixed_program());
  kernel.finish();
  TickChecker checker(mill().limits, kind != ProfileKind::trapezoid);
  Stopped stopped;
  TickStatus status = TickStatus::running;
  for (std::int64_t i = 0; status == TickStatus::running && i < kMaxTicks; ++i) {
    if (i == tick) {
      kernel.stop();
    }
    status = kernel.next(stopped.last);
    stopped.ticks_after += i >= tick ? 1 : 0;
    checker.add({.setpoint = stopped.last, .feedrate_mm_s = 150.0});
  }
  stopped.complaint = complaint_at_end(status, checker, kernel);
  return stopped;
}

TEST(Stop, KeepsEveryLimitAndEndsAtRestOnThePathWhenever) {
  for (const ProfileKind kind :
       {ProfileKind::s_curve, ProfileKind::quintic, ProfileKind::time_optimal}) {
    const auto whole = ticks_of(mixed_program(), {.profile = Profile{kind}});
    for (std::size_t window : {3U, 1000U}) {
      for (std::int64_t tick = 1; tick < whole.back().tick; tick += 97) {
        SCOPED_TRACE(std::string(profiles::name_of(kind)) + ", window " + std::to_string(window) +
                     ", tick " + std::to_string(tick));
        const Stopped stopped = stop_at(tick, kind, window);
        EXPECT_EQ(stopped.complaint, "");
        EXPECT_EQ(stopped.last.v_mm_s, 0.0);
        EXPECT_LE(whole.off_path_mm(stopped.last), 1e-9);
        EXPECT_LE(stopped.ticks_after, kLongestStop_ticks);
        ASSERT_FALSE(testing::Test::HasFailure());
      }
    }
  }
}

// An operator's next command may come while the tool still brakes, or rests and the program has not
// ended. Without a hold, with one just before the stop, in its braking and in its rest.
TEST(Stop, IsTheSameWhateverIsAskedForBehindIt) {
  for (const int held_ticks : {-1, 0, 15, 30, 300}) {
    std::vector<Setpoint> alone;
    for (int after = 200; after >= 0; after -= 3) {
      SCOPED_TRACE("hold " + std::to_string(held_ticks) + ", then " + std::to_string(after));
      Kernel kernel(mill());
      kernel.feed("G21 G90 G61.1 F6000\nG1 X100\nG1 X200\nM2\n");
      kernel.finish();
      std::vector<Setpoint> ticks;
      const auto tick = [&](int count) {
        for (int i = 0; i < count; ++i) {
          kernel.next(ticks.emplace_back());
        }
      };
      tick(500);
      if (held_ticks >= 0) {
        kernel.hold();
        tick(held_ticks);
      }
      kernel.stop();
      tick(after);
      EXPECT_TRUE(kernel.set_overrides({.feed = 0.5}));
      kernel.set_single_block(true);
      kernel.resume();
      kernel.stop();
      tick(800 - static_cast<int>(ticks.size()));
      EXPECT_EQ(kernel.next(ticks.back()), TickStatus::finished);
      EXPECT_FALSE(kernel.fault());
      alone = alone.empty() ? ticks : alone;
      for (std::size_t i = 0; i < ticks.size(); ++i) {
        ASSERT_EQ(ticks[i].position_mm, alone[i].position_mm) << i;
      }
    }
  }
}

// The margin of 10 ms, v/A + A/J = 90 ms, and a tenth for the search over several blocks.
TEST(Stop, TakesLittleLongerThanTheShortestRamp) {
  Kernel kernel(mill());
  std::string text = "G21 G90 F6000\n";
  for (int i = 1; i <= 100; ++i) {
    text += "G1 X" + std::to_string(20 * i) + "\n";
  }
  kernel.feed(text + "M2\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(kernel.next(setpoint), TickStatus::running);
  }
  kernel.stop();
  EXPECT_LE(rest_of(kernel).size(), 10U + 99U + 2U);
}

// The margin of 10 ms.
TEST(Stop, NeedNotWaitForTheEndOfADwell) {
  Kernel kernel(mill());
  kernel.feed("G21 F6000\nG1 X1\nG4 P600\nX2\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(kernel.next(setpoint), TickStatus::running);
  }
  kernel.stop();
  EXPECT_LE(rest_of(kernel).size(), 12U);
}

}  // namespace
}  // namespace kerf::test
