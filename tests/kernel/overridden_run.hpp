// A run whose overrides change at given ticks, judged at each.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

inline constexpr double kFastest_mm_s = 150.0;  // of the mill

using OverridesAt = std::map<std::int64_t, Overrides>;  // before each of these ticks

struct OverriddenRun {
  std::vector<Setpoint> ticks;
  std::string complaint;
};

inline OverriddenRun run_with(const std::string& text, const KernelOptions& options,
                              const OverridesAt& overrides,
                              const MachineSettings& settings = mill()) {
  Kernel kernel(settings, options);
  kernel.feed(text);
  kernel.finish();
  TickChecker checker(settings.limits, options.profile.kind != ProfileKind::trapezoid);
  OverriddenRun run;
  TickStatus status = TickStatus::running;
  while (status != TickStatus::finished && status != TickStatus::failed &&
         run.ticks.size() < kMaxTicks) {
    if (const auto now = overrides.find(static_cast<std::int64_t>(run.ticks.size()));
        now != overrides.end()) {
      EXPECT_TRUE(kernel.set_overrides(now->second));
    }
    Setpoint setpoint;
    status = kernel.next(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = settings.limits.path.velocity_mm_s});
    run.ticks.push_back(setpoint);
  }
  run.complaint = complaint_at_end(status, checker, kernel);
  return run;
}

}  // namespace kerf::test
