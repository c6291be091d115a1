// An output that changes with each of many short lines, as a laser's power does: plans that take
// over hand all of the changes on to their rest over.
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

constexpr double kWayOfProgram_mm = 149.996;
constexpr double kStep_mm = 0.014;

// Of line i.
double power(int i) {
  return 0.001 * (i % 1000);
}

std::string raster_row() {
  std::string text = "G21 G90 G61 F9000\n";
  for (int i = 1; i * kStep_mm <= kWayOfProgram_mm + 1e-9; ++i) {
    text += "M67 E0 Q" + std::to_string(power(i)) + "\nG1 X" + std::to_string(i * kStep_mm) + "\n";
  }
  return text + "M2\n";
}

void expect_in_step(const WatchedRun& run) {
  EXPECT_EQ(run.complaint, "");
  EXPECT_NEAR(run.ticks.back().position_mm[0], kWayOfProgram_mm, 1e-9);
  int rests = 0;
  bool rested = true;
  for (const Setpoint& at : run.ticks) {
    const bool rests_now = at.v_mm_s == 0.0;
    rests += rests_now && !rested ? 1 : 0;
    rested = rests_now;
    const double lines = at.s_mm / kStep_mm;
    const int line = static_cast<int>(lines) + 1;
    const bool is_at_joint = std::abs(lines - std::round(lines)) < 1e-6;
    if (at.s_mm > 0.0 && at.s_mm < kWayOfProgram_mm && !is_at_joint) {
      ASSERT_NEAR(at.outputs.analog[0], power(line), 1e-12) << "at " << at.s_mm;
    }
  }
  EXPECT_EQ(rests, 2);  // of the hold, and at the end
}

// A tick passes over ten of them. Found by reading: a ring was too small for the first part of a
// plan, which was refused again and again until what was emitted before had come to its end.
TEST(DenseOutputs, StayInStepWithTheMotionUnderCommands) {
  const WatchedProgram program{.text = raster_row(),
                               .options = {.profile = {.kind = ProfileKind::time_optimal}},
                               .settings = default_machine()};
  for (const bool has_planning_side : {false, true}) {
    SCOPED_TRACE(has_planning_side ? "planned ahead" : "one thread");
    const WatchedRun run =
        run_ticks(program, [&](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
          if (ran.next() == 150 || ran.next() == 250) {
            kernel.set_overrides({.feed = ran.next() == 150 ? 0.9 : 1.1});
          } else if (ran.next() == 270) {
            kernel.hold();
          } else if (ran.next() == 600) {
            kernel.resume();
          }
          if (!has_planning_side) {
            return kernel.next(setpoint);
          }
          kernel.plan();
          return kernel.tick(setpoint);
        });
    expect_in_step(run);
  }
}

}  // namespace
}  // namespace kerf::test
