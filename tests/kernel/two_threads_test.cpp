// One thread feeds and plans, the other ticks: what they share, for the thread sanitizer too.
#include <algorithm>
#include <atomic>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

// In pieces of some bytes, until the tick side needs no more.
void feed_and_plan(Kernel& kernel, std::string_view text, const std::atomic<bool>& over) {
  constexpr std::size_t kPiece = 7;
  while (!over.load(std::memory_order_relaxed)) {
    if (!kernel.plan()) {
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

// Starved ticks, which depend on how the threads run, are left out.
std::vector<Setpoint> ticks_of_two_threads(const std::string& text, const KernelOptions& options) {
  Kernel kernel(mill(), options);
  std::atomic<bool> over = false;
  std::thread planner([&] { feed_and_plan(kernel, text, over); });
  std::vector<Setpoint> ticks;
  Setpoint setpoint;
  TickStatus status = TickStatus::starved;
  while (status == TickStatus::running || status == TickStatus::starved) {
    status = kernel.tick(setpoint);
    if (status == TickStatus::starved) {
      std::this_thread::yield();
    } else {
      ticks.push_back(setpoint);
    }
  }
  over.store(true, std::memory_order_relaxed);
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
  std::atomic<bool> over = false;
  std::thread planner([&] { feed_and_plan(kernel, "G21 G90\nG1 X10 F3000\nX20 F-1\nM2\n", over); });
  Setpoint setpoint;
  TickStatus status = TickStatus::starved;
  while (status == TickStatus::running || status == TickStatus::starved) {
    status = kernel.tick(setpoint);
    std::this_thread::yield();
  }
  over.store(true, std::memory_order_relaxed);
  planner.join();
  EXPECT_EQ(status, TickStatus::failed);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_TRUE(kernel.has_errors());
}

}  // namespace
}  // namespace kerf::test
