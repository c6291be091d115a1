// A way to rest that ends some microseconds after a tick: where another plan takes over at that
// tick there is hardly a way left, but the acceleration is not 0 yet.
#include <cstdint>
#include <functional>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

using KernelCommand = std::function<void(Kernel&)>;

// Planned once, so that the tool takes the way to rest at the end of that. From 100.006 mm/s it
// takes v/A + A/J = 50.003 + 40 ms.
constexpr const char* kLineProgram = "G21 G90 G61\nG1 X200 F6000.36\nM2\n";
constexpr std::int64_t kLastInMotion = 270;
constexpr std::int64_t kMargin = 10;  // ticks from a command to the tick at which its plan begins

WatchedRun run_commanded(const KernelOptions& options, const KernelCommand& command) {
  return run_ticks({.text = kLineProgram, .options = options},
                   [&](Kernel& kernel, const WatchedRun& run, Setpoint& setpoint) {
                     const std::int64_t command_at = kLastInMotion - kMargin;
                     if (run.next() == command_at) {
                       command(kernel);
                     }
                     if (run.next() == 0 || run.next() > command_at) {
                       kernel.plan();
                     }
                     if (run.next() % 1000 == 0) {
                       kernel.resume();  // from a hold, and where single block waits
                     }
                     return kernel.tick(setpoint);
                   });
}

TEST(RestBehindATick, IsRunToItsEndBeforeAnotherPlanBegins) {
  const KernelCommand commands[] = {
      [](Kernel& kernel) { kernel.set_overrides({.feed = 0.9}); },
      [](Kernel& kernel) { kernel.set_single_block(true); },
      [](Kernel& kernel) { kernel.hold(); },
      [](Kernel& kernel) { kernel.stop(); },
  };
  for (const ProfileKind kind : {ProfileKind::time_optimal, ProfileKind::s_curve}) {
    for (std::size_t i = 0; i < std::size(commands); ++i) {
      SCOPED_TRACE(i);
      const WatchedRun run = run_commanded({.profile = {.kind = kind}}, commands[i]);
      EXPECT_EQ(run.complaint, "");
      const Setpoint& last = run.ticks.at(kLastInMotion);
      const double left_s = -last.a_mm_s2 / mill().limits.path.jerk_mm_s3;
      EXPECT_NEAR(left_s, 3e-6, 1e-9);
      EXPECT_NEAR(last.v_mm_s, 0.5 * mill().limits.path.jerk_mm_s3 * left_s * left_s, 1e-9);
      EXPECT_EQ(run.ticks.at(kLastInMotion + 1).v_mm_s, 0.0);
    }
  }
}

}  // namespace
}  // namespace kerf::test
