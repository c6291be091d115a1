// A kernel that is run to its end, commanded before any of its ticks, and judged at each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

inline constexpr double kFastest_mm_s = 150.0;  // of the mill

struct WatchedRun {
  std::vector<Setpoint> ticks;
  std::vector<TickStatus> statuses;
  std::string complaint;  // empty: every limit at each tick, and it finished

  // How many ticks there are so far: the next one's index.
  [[nodiscard]] std::int64_t next() const { return std::ssize(ticks); }
  [[nodiscard]] std::int64_t count(TickStatus status) const {
    return std::ranges::count(statuses, status);
  }
  // How many of the last ticks, without a break, have the status.
  [[nodiscard]] std::int64_t count_at_end(TickStatus status) const {
    return std::find_if(statuses.rbegin(), statuses.rend(),
                        [status](TickStatus other) { return other != status; }) -
           statuses.rbegin();
  }
  // The first held tick; the last tick where there is none.
  [[nodiscard]] const Setpoint& first_held() const {
    const auto held = std::ranges::find(statuses, TickStatus::held);
    return held == statuses.end() ? ticks.back()
                                  : ticks[static_cast<std::size_t>(held - statuses.begin())];
  }
};

struct WatchedProgram {
  std::string text{};
  KernelOptions options{};
  MachineSettings settings = mill();
  bool comes_later = false;  // the text: it is fed between ticks
};

// tick: makes the next tick, given the kernel and what has run so far.
template <typename Tick>
WatchedRun run_ticks(const WatchedProgram& program, Tick tick) {
  Kernel kernel(program.settings, program.options);
  if (!program.comes_later) {
    kernel.feed(program.text);
    kernel.finish();
  }
  TickChecker checker(program.settings.limits,
                      program.options.profile.kind != ProfileKind::trapezoid);
  WatchedRun run;
  TickStatus status = TickStatus::running;
  while (status != TickStatus::finished && status != TickStatus::failed && run.next() < kMaxTicks) {
    Setpoint setpoint;
    status = tick(kernel, run, setpoint);
    checker.add(
        {.setpoint = setpoint, .feedrate_mm_s = program.settings.limits.path.velocity_mm_s});
    run.ticks.push_back(setpoint);
    run.statuses.push_back(status);
  }
  run.complaint = complaint_at_end(status, checker, kernel);
  return run;
}

// before: sees the kernel and what has run so far before each tick.
template <typename Before>
WatchedRun watched_run(const WatchedProgram& program, Before before) {
  return run_ticks(program, [&](Kernel& kernel, const WatchedRun& run, Setpoint& setpoint) {
    before(kernel, run);
    return kernel.next(setpoint);
  });
}

inline constexpr std::int64_t kHeldTicks = 20;

// Calls hold() before each of these ticks, and resume() once the tool has been held for some time.
inline WatchedRun run_held(const WatchedProgram& program,
                           const std::set<std::int64_t>& hold_before) {
  return watched_run(program, [&](Kernel& kernel, const WatchedRun& run) {
    if (run.count_at_end(TickStatus::held) == kHeldTicks) {
      kernel.resume();
    }
    if (hold_before.contains(run.next())) {
      kernel.hold();
    }
  });
}

}  // namespace kerf::test
