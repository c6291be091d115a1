// Holds for which the search takes long: ticks go on at the first looks that it takes at them.
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

constexpr int kHeldLongTicks = 20;
constexpr int kSlowLooks = 8;
#ifdef KERF_SLOW_BUILD
constexpr std::int64_t kBetween = 1170;
#else
constexpr std::int64_t kBetween = 390;
#endif

struct SlowHold {
  std::vector<Setpoint> ticks{};
  std::string complaint{};  // empty: every limit at each tick, and it finished
  std::size_t held = 0;     // the first held tick
};

// Holds before the tick, and resumes.
SlowHold held_at(const std::string& text, std::int64_t tick, int ticks_of_look) {
  SlowHold run;
  Kernel* asked = nullptr;
  TickStatus status = TickStatus::running;
  TickChecker checker(default_machine().limits, true);
  int held = 0;
  int looks = 0;  // of a call of plan()
  const auto next = [&](Kernel& kernel) {
    Setpoint setpoint;
    status = kernel.tick(setpoint);
    checker.add(
        {.setpoint = setpoint, .feedrate_mm_s = default_machine().limits.path.velocity_mm_s});
    run.ticks.push_back(setpoint);
    held += status == TickStatus::held ? 1 : 0;
    run.held = held == 1 ? run.ticks.size() - 1 : run.held;
  };
  KernelOptions options;
  options.plan_clock = [&](std::int64_t /*ticks*/) {
    for (int i = 0; asked != nullptr && i < ticks_of_look && looks < kSlowLooks; ++i) {
      next(*asked);
    }
    ++looks;
    return true;
  };
  Kernel kernel(default_machine(), options);
  kernel.feed(text);
  kernel.finish();
  while (status != TickStatus::finished && status != TickStatus::failed &&
         run.ticks.size() < kMaxTicks) {
    if (std::ssize(run.ticks) == tick) {
      asked = &kernel;
      looks = 0;
      kernel.hold();
    }
    looks = 0;
    kernel.plan();
    if (held >= kHeldLongTicks) {
      asked = nullptr;
      kernel.resume();
    }
    next(kernel);
  }
  run.complaint = complaint_at_end(status, checker, kernel);
  return run;
}

// The first that is another.
std::size_t changed_at(const SlowHold& run, const std::vector<Setpoint>& whole) {
  std::size_t i = 0;
  while (i < run.ticks.size() && run.ticks[i].position_mm == whole.at(i).position_mm) {
    ++i;
  }
  return i;
}

TEST(SlowHold, BeginsSoonAndKeepsThePathAndTheLimits) {
  const std::string text = shipped_program("butterfly.ngc");
  Kernel kernel(default_machine());
  kernel.feed(text);
  kernel.finish();
  const WholeRun whole(rest_of(kernel), text, {}, default_machine());
  int longer = 0;
  for (std::int64_t tick = 250; tick + 250 < whole.back().tick; tick += kBetween) {
    SCOPED_TRACE(tick);
    const SlowHold quick = held_at(text, tick, 0);
    const SlowHold slow = held_at(text, tick, 2);
    expect_whole(slow, whole);
    constexpr std::int64_t kReaction = 60;
    EXPECT_LE(static_cast<std::int64_t>(changed_at(slow, whole)), tick + kReaction);
    longer += slow.held > quick.held ? 1 : 0;
  }
  EXPECT_GT(longer, 0) << "no search was cut short";
}

}  // namespace
}  // namespace kerf::test
