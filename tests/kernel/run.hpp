// Programs run to their end, for the kernel's tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "interp/setpoint.hpp"
#include "tests/kernel/off_path.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

using interp::Setpoint;
using interp::TickStatus;

inline constexpr std::int64_t kMaxTicks = 200'000;

inline std::vector<Setpoint> rest_of(Kernel& kernel) {
  std::vector<Setpoint> ticks;
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  while (status == TickStatus::running && ticks.size() < kMaxTicks) {
    status = kernel.next(setpoint);
    ticks.push_back(setpoint);
  }
  EXPECT_EQ(status, kernel.has_errors() ? TickStatus::failed : TickStatus::finished);
  EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
  return ticks;
}

// On the mill.
inline std::vector<Setpoint> ticks_of(const std::string& text, const KernelOptions& options = {}) {
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  auto ticks = rest_of(kernel);
  EXPECT_FALSE(kernel.has_errors());
  for (const auto& found : kernel.diagnostics()) {
    ADD_FAILURE() << found.source.line << ": " << found.message;
  }
  return ticks;
}

// Of a run that is to have finished; empty: everything holds.
inline std::string complaint_at_end(TickStatus status, const TickChecker& checker,
                                    const Kernel& kernel) {
  const std::string complaint =
      status == TickStatus::finished ? checker.complaint() : "did not finish";
  return complaint + (kernel.fault() ? kernel.fault()->what : "");
}

// Run: ticks and a complaint, of a program under commands. whole: of the same one without.
template <typename Run>
void expect_whole(const Run& run, const std::vector<Setpoint>& whole) {
  EXPECT_EQ(run.complaint, "");
  double off_mm = 0.0;
  for (const Setpoint& tick : run.ticks) {
    off_mm = std::max(off_mm, off_path_mm(whole, tick));
  }
  EXPECT_LE(off_mm, 1e-9);
  EXPECT_EQ(run.ticks.back().position_mm, whole.back().position_mm);
  EXPECT_EQ(run.ticks.back().outputs, whole.back().outputs);
}

}  // namespace kerf::test
