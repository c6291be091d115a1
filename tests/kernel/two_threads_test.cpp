// One thread feeds and plans, the other ticks: what they share, for the thread sanitizer too.
#include <algorithm>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

// Stands for the clock of a machine: a planning thread that is later than the horizon, 250 ticks,
// breaks what the kernel promises, and without a clock the tick side may run away from it.
struct Clock {
  static constexpr std::int64_t kTicksAhead = 100;
  std::atomic<std::int64_t> ticks = 0;
  std::atomic<std::int64_t> allowed = 0;
  std::atomic<bool> over = false;
};

// In pieces of some bytes, until the tick side needs no more.
void feed_and_plan(Kernel& kernel, std::string_view text, Clock& clock) {
  constexpr std::size_t kPiece = 7;
  while (!clock.over.load(std::memory_order_relaxed)) {
    if (!kernel.plan()) {
      clock.allowed.store(clock.ticks.load(std::memory_order_relaxed) + Clock::kTicksAhead,
                          std::memory_order_relaxed);
      std::this_thread::yield();
      continue;
    }
    kernel.feed(text.substr(0, kPiece));
    text.remove_prefix(std::min(kPiece, text.size()));
    if (text.empty()) {
      kernel.finish();
    }
  }
}

TickStatus next_tick(Kernel& kernel, Clock& clock, Setpoint& setpoint) {
  while (clock.ticks.load(std::memory_order_relaxed) >=
         clock.allowed.load(std::memory_order_relaxed)) {
    std::this_thread::yield();
  }
  clock.ticks.fetch_add(1, std::memory_order_relaxed);
  return kernel.tick(setpoint);
}

// Starved ticks, which depend on how the threads run, are left out.
std::vector<Setpoint> ticks_of_two_threads(const std::string& text, const KernelOptions& options) {
  Kernel kernel(mill(), options);
  Clock clock;
  std::thread planner([&] { feed_and_plan(kernel, text, clock); });
  std::vector<Setpoint> ticks;
  Setpoint setpoint;
  TickStatus status = TickStatus::starved;
  while (status == TickStatus::running || status == TickStatus::starved) {
    status = next_tick(kernel, clock, setpoint);
    if (status != TickStatus::starved) {
      ticks.push_back(setpoint);
    }
  }
  clock.over.store(true, std::memory_order_relaxed);
  planner.join();
  EXPECT_EQ(status, TickStatus::finished);
  EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
  return ticks;
}

TEST(TwoThreads, GiveTheTicksOfOne) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    SCOPED_TRACE(name_of(kind));
    const KernelOptions options{.profile = {.kind = kind}};
    const std::vector<Setpoint> one = ticks_of(mixed_program(), options);
    const std::vector<Setpoint> two = ticks_of_two_threads(mixed_program(), options);
    // Where no text was there in time, the window came to rest earlier, so only the path is one.
    ASSERT_FALSE(two.empty());
    EXPECT_EQ(two.back().position_mm, one.back().position_mm);
    EXPECT_EQ(two.back().s_mm, one.back().s_mm);
    EXPECT_EQ(two.back().outputs, one.back().outputs);
  }
}

TEST(TwoThreads, ComeToRestWhereTheProgramIsWrong) {
  Kernel kernel(mill());
  Clock clock;
  std::thread planner(
      [&] { feed_and_plan(kernel, "G21 G90\nG1 X10 F3000\nX20 F-1\nM2\n", clock); });
  Setpoint setpoint;
  TickStatus status = TickStatus::starved;
  while (status == TickStatus::running || status == TickStatus::starved) {
    status = next_tick(kernel, clock, setpoint);
  }
  clock.over.store(true, std::memory_order_relaxed);
  planner.join();
  EXPECT_EQ(status, TickStatus::failed);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_TRUE(kernel.has_errors());
}

}  // namespace
}  // namespace kerf::test
