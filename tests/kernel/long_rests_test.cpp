// Rests that take longer than a part of the plan: in a tap, and while a spindle starts.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

// A dwell is emitted in parts.
TEST(Tap, IsStoppedByNothingWithinALongDwellToo) {
  const std::string text =
      "G21 G90 G61 F3000\nM3 S600\nG84 X0 Y0 Z-2 R1 P0.6 F600\nG80\nG1 X5\nM2\n";
  for (const bool stops : {false, true}) {
    const WatchedRun run = run_ticks(
        {.text = text}, [stops](Kernel& kernel, const WatchedRun& now, Setpoint& setpoint) {
          if (now.next() == 600) {
            EXPECT_EQ(now.ticks.back().position_mm[2], -2.0);
            stops ? kernel.stop() : kernel.hold();
          } else if (now.next() == 3000) {
            EXPECT_EQ(now.statuses.back(), TickStatus::held);
            kernel.resume();
          }
          kernel.plan();
          return kernel.tick(setpoint);
        });
    EXPECT_EQ(run.complaint, "");
    const Setpoint& rests = stops ? run.ticks.back() : run.first_held();
    EXPECT_EQ(rests.position_mm[2], 1.0);
    EXPECT_GT(rests.outputs.spindle_rad_s, 0.0);
  }
}

// It is late, and the tool rests where the tap ended.
TEST(Tap, MayBeStoppedBehindItWhereTextIsLate) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G61 F3000\nM3 S600\nG84 X0 Y0 Z-2 R1 F600\n");
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  for (int i = 0; i < 3000; ++i) {
    if (kernel.plan()) {
      kernel.plan_to_rest();
    }
    if (i == 2000) {
      EXPECT_EQ(setpoint.position_mm[2], 1.0);
      kernel.stop();
    }
    status = kernel.tick(setpoint);
    if (status == TickStatus::finished) {
      break;
    }
  }
  EXPECT_EQ(status, TickStatus::finished);
}

std::size_t ticks_with(double spindle_start_s, const std::string& text,
                       const KernelOptions& options = {}) {
  MachineSettings machine = mill();
  machine.program.spindle_start_s = spindle_start_s;
  const WatchedRun run = run_ticks({.text = text, .options = options, .settings = machine},
                                   [](Kernel& kernel, const WatchedRun&, Setpoint& setpoint) {
                                     kernel.plan();
                                     return kernel.tick(setpoint);
                                   });
  EXPECT_EQ(run.complaint, "");
  return run.ticks.size();
}

// Found by reading: after M6, which stops it, and after S0 it was taken to turn already.
TEST(SpindleStart, TakesItsTimeWheneverItStoodBefore) {
  const auto starts_of = [](const std::string& text, const KernelOptions& options = {}) {
    return static_cast<double>(ticks_with(2.0, text, options) - ticks_with(0.0, text, options)) /
           2000.0;
  };
  EXPECT_NEAR(starts_of("G21 G90 F3000\nM3 S600\nG1 X1\nT2 M6\nM3 S600\nX2\nM2\n"), 2.0, 0.01);
  EXPECT_NEAR(starts_of("G21 G90 F3000\nM3 S0\nG1 X1\nM3 S600\nX2\nM2\n"), 1.0, 0.01);
  EXPECT_NEAR(starts_of("G21 G90 F3000\nM3 S600\nG1 X1\nS900\nX2\nM2\n"), 1.0, 0.01);
  KernelOptions turns;
  turns.start_outputs.spindle_rad_s = 60.0;
  EXPECT_NEAR(starts_of("G21 G90 F3000\nM3 S600\nG1 X1\nM2\n", turns), 0.0, 0.01);
}

// Its output changes at the begin of the time that it takes.
TEST(SpindleStart, BeginsWithItsTime) {
  MachineSettings machine = mill();
  machine.program.spindle_start_s = 2.0;
  const WatchedRun run =
      run_ticks({.text = "G21 G90 G61 F3000\nG1 X1\nM3 S600\nX2\nM2\n", .settings = machine},
                [](Kernel& kernel, const WatchedRun&, Setpoint& setpoint) {
                  kernel.plan();
                  return kernel.tick(setpoint);
                });
  EXPECT_EQ(run.complaint, "");
  const auto turning = std::ranges::count_if(run.ticks, [](const Setpoint& tick) {
    return tick.outputs.spindle_rad_s > 0.0 && tick.position_mm[0] == 1.0;
  });
  EXPECT_NEAR(static_cast<double>(turning), 2000.0, 2.0);
}

}  // namespace
}  // namespace kerf::test
