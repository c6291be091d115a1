// An override while the tool speeds up or slows down, and the profile behind it.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/overridden_run.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

// Found with a client: over half of the ramp to the feedrate no plan was found from the motion,
// which has all of its jerk there, and the tool came to rest.
TEST(Override, WhileALineSpeedsUpLeadsToItsFeedrateWithoutARest) {
  for (const double share : {0.9, 0.5, 0.1}) {
    for (std::int64_t asked = 12; asked <= 64; asked += 4) {
      SCOPED_TRACE("at tick " + std::to_string(asked) + " " + std::to_string(share));
      Kernel kernel(mill());
      kernel.feed("G21 G90 G61\nG1 X100 F6000\nM2\n");
      kernel.finish();
      TickChecker checker(mill().limits, true);
      Setpoint setpoint;
      double least_mm_s = 100.0 * share;
      TickStatus status = TickStatus::running;
      while (status == TickStatus::running) {
        status = kernel.next(setpoint);
        checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
        if (setpoint.tick == asked) {
          least_mm_s = std::min(least_mm_s, setpoint.v_mm_s);
          kernel.set_overrides({.feed = share});
        } else if (setpoint.tick > asked && setpoint.position_mm[0] < 60.0) {
          EXPECT_GT(setpoint.v_mm_s, 0.98 * least_mm_s) << setpoint.tick;
          ASSERT_FALSE(HasFailure());
        }
      }
      EXPECT_EQ(complaint_at_end(status, checker, kernel), "");
    }
  }
}

// Found with a client: from none of the ticks of a long ramp a way to rest was found, and where the
// queue ended there the tool rested for ever.
TEST(Override, OfATrapezoidLeadsBeyondARampWithoutAWayToRest) {
  MachineSettings machine = default_machine();
  machine.limits.path = {.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 5e4};
  machine.limits.axes = {MotionLimits{200.0, 2000.0, 4e4}, MotionLimits{150.0, 3000.0, 2e4},
                         MotionLimits{80.0, 800.0, 1.5e4}};
  const WatchedRun run =
      run_ticks({.text = "G21 G90 G61 F8647\nG1 X2.635949 Y2.023274\nG1 X9.857683 Y7.566456\n"
                         "G1 X14.688382 Y14.449174\n"
                         "G3 X11.844012893459 Y32.412707275220 I-10.703268821443 J7.512187743351\n"
                         "G1 X7.260464 Y35.859311\nM2\n",
                 .options = {.profile = {.kind = ProfileKind::trapezoid}},
                 .settings = machine},
                [](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
                  kernel.plan();
                  if (ran.next() == 28) {
                    EXPECT_TRUE(kernel.set_overrides({.feed = 1.5}));
                  }
                  return kernel.tick(setpoint);
                });
  EXPECT_EQ(run.complaint, "");
  EXPECT_LE(run.count(TickStatus::starved), 1);  // before the first plan
}

// The way down to it is no profile's own: it begins with any acceleration.
TEST(Override, GoesOnWithTheChosenProfileFromACruise) {
  const auto braking = [](const WatchedRun& run) {
    std::vector<double> a_mm_s2;
    for (auto tick = run.ticks.rbegin(); tick->v_mm_s < 49.9; ++tick) {
      a_mm_s2.push_back(tick->a_mm_s2);
    }
    return a_mm_s2;
  };
  for (const ProfileKind kind : {ProfileKind::sine, ProfileKind::quintic, ProfileKind::sigmoid,
                                 ProfileKind::sine_series, ProfileKind::s_curve}) {
    SCOPED_TRACE(name_of(kind));
    const KernelOptions options{.profile = {.kind = kind}};
    const WatchedRun whole = run_with("G21 G90 G61\nG1 X400 F3000\nM2\n", options, {});
    const WatchedRun run =
        run_with("G21 G90 G61\nG1 X400 F6000\nM2\n", options, {{1000, {.feed = 0.5}}});
    EXPECT_EQ(whole.complaint + run.complaint, "");
    const std::vector<double> of_profile = braking(whole);
    const std::vector<double> found = braking(run);
    ASSERT_NEAR(static_cast<double>(found.size()), static_cast<double>(of_profile.size()), 1.0);
    // The least may lie between two ticks: half of what the jerk of 5e4 mm/s^3 makes of one.
    EXPECT_NEAR(*std::ranges::min_element(found), *std::ranges::min_element(of_profile), 25.0);
  }
}

// Found with a client: where the plan of the other feedrate began at the rest of a corner, the tool
// waited there for what comes after it.
TEST(Override, RightBeforeARestIsNoWaitForThePlanBehindIt) {
  for (std::int64_t asked = 100; asked <= 200; asked += 2) {
    const WatchedRun run =
        run_ticks({.text = "G21 G90 G61\nG1 X10 F6000\nX0\nX10\nM2\n"},
                  [asked](Kernel& kernel, const WatchedRun& ran, Setpoint& setpoint) {
                    kernel.plan();
                    if (ran.next() == asked) {
                      kernel.set_overrides({.feed = 0.9});
                    }
                    return kernel.tick(setpoint);
                  });
    EXPECT_EQ(run.complaint, "") << asked;
    EXPECT_EQ(run.count(TickStatus::starved), 0) << asked;
  }
}

}  // namespace
}  // namespace kerf::test
