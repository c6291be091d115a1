// Programs run to their end, for the kernel's tests.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "interp/setpoint.hpp"
#include "tests/kernel/planned_path.hpp"
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

// The ticks of a program without commands, and its path.
class WholeRun : public std::vector<Setpoint> {
 public:
  WholeRun(std::vector<Setpoint> ticks, std::string text, const KernelOptions& options,
           const MachineSettings& settings = mill())
      : std::vector<Setpoint>(std::move(ticks)),
        text_(std::move(text)),
        options_(options),
        settings_(settings) {}

  // PlannedPath::off_mm
  [[nodiscard]] double off_path_mm(const Setpoint& setpoint) const {
    if (!path_) {
      path_.emplace(settings_, options_, text_);
    }
    return path_->off_mm(setpoint);
  }

 private:
  std::string text_;
  KernelOptions options_;
  MachineSettings settings_;
  mutable std::optional<PlannedPath> path_;  // planned once it is asked for
};

// On the mill.
inline WholeRun ticks_of(const std::string& text, const KernelOptions& options = {}) {
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  auto ticks = rest_of(kernel);
  EXPECT_FALSE(kernel.has_errors());
  for (const auto& found : kernel.diagnostics()) {
    ADD_FAILURE() << found.source.line << ": " << found.message;
  }
  return {std::move(ticks), text, options};
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
void expect_whole(const Run& run, const WholeRun& whole) {
  EXPECT_EQ(run.complaint, "");
  double off_mm = 0.0;
  for (const Setpoint& tick : run.ticks) {
    off_mm = std::max(off_mm, whole.off_path_mm(tick));
  }
  EXPECT_LE(off_mm, 1e-9);
  EXPECT_EQ(run.ticks.back().position_mm, whole.back().position_mm);
  EXPECT_EQ(run.ticks.back().outputs, whole.back().outputs);
}

}  // namespace kerf::test
