// An emergency stop at any tick, with nothing planned after it.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "parser/text/letters.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

// Of the second differences over the limit, where a bend tightens.
constexpr double kRounding = 1.0007;

struct EmergencyStopped {
  std::vector<Setpoint> ticks;  // from two before the stop on
  TickStatus status = TickStatus::running;
};

void stop(Kernel& kernel, EmergencyStopped& stopped) {
  kernel.emergency_stop();
  for (int i = 0; i < 1000 && stopped.status == TickStatus::running; ++i) {
    Setpoint setpoint;
    stopped.status = kernel.tick(setpoint);
    stopped.ticks.push_back(setpoint);
  }
}

EmergencyStopped stop_at(std::int64_t tick, const std::string& text, const KernelOptions& options,
                         const MachineSettings& machine = mill()) {
  Kernel kernel(machine, options);
  kernel.feed(text);
  kernel.finish();
  EmergencyStopped stopped;
  Setpoint setpoint;
  for (std::int64_t i = 0; i < tick; ++i) {
    kernel.plan();
    kernel.tick(setpoint);
    if (i + 2 >= tick) {
      stopped.ticks.push_back(setpoint);
    }
  }
  stop(kernel, stopped);
  return stopped;
}

// In a copy of the process, which leaves this one as it is.
template <typename Check>
bool holds_in_copy(Check check) {
  const pid_t copy = ::fork();
  if (copy == 0) {
    ::_exit(check() ? 0 : 1);
  }
  int status = 0;
  return copy > 0 && ::waitpid(copy, &status, 0) == copy && WIFEXITED(status) &&
         WEXITSTATUS(status) == 0;
}

// The largest acceleration of an axis over its limit.
double largest_share(const std::vector<Setpoint>& ticks, const MachineSettings& machine = mill()) {
  double largest = 0.0;
  for (std::size_t i = 2; i < ticks.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double second =
          ticks[i].position_mm[k] - 2.0 * ticks[i - 1].position_mm[k] + ticks[i - 2].position_mm[k];
      largest =
          std::max(largest, std::abs(second) / 1e-6 / machine.limits.axes[k].acceleration_mm_s2);
    }
  }
  return largest;
}

TEST(EmergencyStop, KeepsAccelerationsAndThePathWhenever) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(mixed_program(), options);
    for (std::int64_t tick = 3; tick < whole.back().tick; tick += 37) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick));
      const EmergencyStopped stopped = stop_at(tick, mixed_program(), options);
      ASSERT_EQ(stopped.status, TickStatus::emergency_stop);
      EXPECT_LE(largest_share(stopped.ticks), kRounding);
      for (std::size_t i = 1; i < stopped.ticks.size(); ++i) {
        ASSERT_LE(whole.off_path_mm(stopped.ticks[i]), 1e-9);
        ASSERT_TRUE(i < 3 || stopped.ticks[i].v_mm_s <= stopped.ticks[i - 1].v_mm_s);
      }
    }
  }
}

// Found with a client: the tool came into the bend faster than planned, too fast to brake there.
TEST(EmergencyStop, KeepsTheAccelerationsOfUnequalAxesInABend) {
  const std::string text =
      "G21 G90 G61\nG1 X5 F9000\nG5.2 X5 Y0 P1 L3\nX10 Y15 P1\nX20 Y-10 P2\nX30 Y20 P1\n"
      "X40 Y0 P1\nX44 Y5 P1\nX45 Y0 P1\nG5.3\nG1 X60 Y-5\nM2\n";
  MachineSettings machine = mill();
  machine.limits.path = {
      .velocity_mm_s = 300.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 60'000.0};
  machine.limits.axes[0] = {
      .velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 50'000.0};
  machine.limits.axes[1] = {
      .velocity_mm_s = 180.0, .acceleration_mm_s2 = 1500.0, .jerk_mm_s3 = 30'000.0};
  for (std::int64_t tick = 950; tick < 990; tick += 5) {
    const EmergencyStopped stopped = stop_at(tick, text, {}, machine);
    ASSERT_EQ(stopped.status, TickStatus::emergency_stop);
    EXPECT_LE(largest_share(stopped.ticks, machine), kRounding) << "tick " << tick;
  }
}

// Blocks of a third of a tick: what is over is passed before the tick comes.
TEST(EmergencyStop, HasTheLengthOfThePathWhereBlocksAreShorterThanATick) {
  std::string text = "G21 G90 G61 F6000\n";
  for (int i = 1; i <= 900; ++i) {
    text += "G1 X" + std::to_string(0.03 * i) + "\n";
  }
  text += "M2\n";
  for (int tick = 100; tick < 250; ++tick) {
    Kernel kernel(mill());
    kernel.feed(text);
    kernel.finish();
    Setpoint setpoint;
    for (int i = 0; i < tick; ++i) {
      kernel.next(setpoint);
    }
    kernel.reach_tick();
    kernel.emergency_stop();
    for (TickStatus status = TickStatus::running; status == TickStatus::running;) {
      status = kernel.tick(setpoint);
      ASSERT_NEAR(setpoint.s_mm, setpoint.position_mm[0], 1e-9) << tick;
    }
  }
}

// Where the bend alone takes more of an axis than it has, the plan speeds up, and no motion that
// brakes keeps the limit.
TEST(EmergencyStop, KeepsTheLimitsOfUnequalAxesWhereTheyLetNoneBrake) {
  MachineSettings machine = default_machine();
  machine.limits.path = {.velocity_mm_s = 300.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 6e4};
  machine.limits.axes[0] = {
      .velocity_mm_s = 250.0, .acceleration_mm_s2 = 1113.4, .jerk_mm_s3 = 5e4};
  machine.limits.axes[1] = {.velocity_mm_s = 180.0, .acceleration_mm_s2 = 309.0, .jerk_mm_s3 = 3e4};
  const std::string text =
      "G21 G90 G64 P0.3\nG1 X5 F12000\n"
      "G5 I3.013 J0.067 P-1.973 Q1.655 X15.695 Y2.309\n"
      "G5 I1.810 J1.707 P-3.292 Q-1.703 X24.569 Y0.386\n"
      "G5 I2.865 J-1.278 P-3.425 Q5.689 X29.634 Y-7.135\n"
      "G5 I3.307 J5.283 P-2.686 Q2.786 X37.623 Y-2.466\n"
      "G5 I2.614 J3.117 P-3.959 Q-5.824 X44.840 Y-3.397\n"
      "G5 I3.463 J-3.805 P-1.936 Q4.626 X55.427 Y6.888\n"
      "G5 I2.907 J-4.837 P-1.288 Q-5.034 X63.502 Y2.299\n"
      "G5 I2.760 J0.993 P-2.931 Q0.398 X69.608 Y-6.850\nG1 X60 Y-5\nM2\n";
  Kernel kernel(machine);
  kernel.feed(text);
  kernel.finish();
  EmergencyStopped run;
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    if (tick >= 100 && tick % 7 == 2) {
      ASSERT_EQ(run.status, TickStatus::running);
      EXPECT_TRUE(holds_in_copy([&] {
        EmergencyStopped stopped{.ticks = {run.ticks.end() - 2, run.ticks.end()}};
        stop(kernel, stopped);
        return stopped.status == TickStatus::emergency_stop &&
               largest_share(stopped.ticks, machine) <= kRounding;
      })) << "tick "
          << tick;
    }
    kernel.plan();
    run.status = kernel.tick(run.ticks.emplace_back());
  }
}

// v^2 / 2A, with the whole acceleration from the next tick on.
TEST(EmergencyStop, OnALineTakesTheShortestWay) {
  const EmergencyStopped stopped = stop_at(1000, "G21 G90\nG1 X1000 F6000\nM2\n", {});
  EXPECT_NEAR(stopped.ticks.back().s_mm - stopped.ticks[1].s_mm, 100.0 * 100.0 / 4000.0, 1e-6);
  EXPECT_EQ(stopped.ticks.back().v_mm_s, 0.0);
}

TEST(EmergencyStop, KeepsTheAccelerationOfThePathWhereTheAxesHaveMore) {
  MachineSettings machine = mill();
  machine.limits.path.acceleration_mm_s2 = 800.0;
  const EmergencyStopped stopped = stop_at(1000, "G21 G90\nG1 X1000 F6000\nM2\n", {}, machine);
  EXPECT_NEAR(stopped.ticks.back().s_mm - stopped.ticks[1].s_mm, 100.0 * 100.0 / 1600.0, 1e-6);
}

// Of an axis at constant velocity, in step with the path or alone: v^2 / 2A.
TEST(EmergencyStop, TakesTheWholeAccelerationOfAFurtherAxisThatBrakesTheLeast) {
  constexpr std::size_t kA = 0;
  constexpr std::size_t kU = 3;
  MachineSettings machine = mill();
  machine.program.extra_axes = parser::letters('A', 'U');
  machine.limits.extra[kA] = {
      .velocity_mm_s = 3.0, .acceleration_mm_s2 = 30.0, .jerk_mm_s3 = 600.0};
  machine.limits.extra[kU] = {
      .velocity_mm_s = 20.0, .acceleration_mm_s2 = 200.0, .jerk_mm_s3 = 4e3};
  for (const auto& [move, axis] : {std::pair{"X500 A600", kA},
                                   {"X500 Y300 A900 U50", kA},
                                   {"X500 A90 U300", kU},
                                   {"A600", kA}}) {
    SCOPED_TRACE(move);
    const EmergencyStopped stopped =
        stop_at(1200, std::string("G21 G90 G61\nG1 F6000 ") + move + "\nM2\n", {}, machine);
    ASSERT_EQ(stopped.status, TickStatus::emergency_stop);
    const auto at = [&](const Setpoint& tick) { return tick.extra_rad_mm.at(axis); };
    const double velocity = (at(stopped.ticks[1]) - at(stopped.ticks[0])) / 1e-3;
    EXPECT_GT(velocity, 1.0);
    EXPECT_NEAR(at(stopped.ticks.back()) - at(stopped.ticks[1]),
                velocity * velocity / (2.0 * machine.limits.extra.at(axis).acceleration_mm_s2),
                1e-6);
    EXPECT_LE(largest_share(stopped.ticks, machine), kRounding);
  }
}

TEST(EmergencyStop, TurnsSpindleAndCoolantOffAtOnce) {
  const EmergencyStopped stopped = stop_at(1000, "G21 G90 M3 S1000 M8\nG1 X1000 F6000\nM2\n", {});
  EXPECT_NE(stopped.ticks[1].outputs.spindle_rad_s, 0.0);
  EXPECT_TRUE(stopped.ticks[1].outputs.flood);
  EXPECT_EQ(stopped.ticks[2].outputs.spindle_rad_s, 0.0);
  EXPECT_FALSE(stopped.ticks[2].outputs.flood);
}

// Found by reading: the rests and blocks after a dwell in which it came were taken for run, and
// what they switch for in force.
TEST(EmergencyStop, InADwellLeavesWhatComesBehindIt) {
  Kernel kernel(mill(), {.tells_operator = true});
  kernel.feed("G21 G90\nG1 X10 F6000\nG4 P0.15\nG91 M9\nG4 P0.1\nM64 P3\nG1 X5\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  TickStatus status = TickStatus::starved;
  for (int ticks_of_dwell = 0; ticks_of_dwell < 50;) {
    kernel.plan();
    status = kernel.tick(setpoint);
    ticks_of_dwell += setpoint.line == 3 ? 1 : 0;
  }
  const std::uint64_t block = kernel.detail().block;
  kernel.emergency_stop();
  for (int i = 0; i < 10; ++i) {
    kernel.plan();
    status = kernel.tick(setpoint);
    EXPECT_EQ(setpoint.line, 3U);
    EXPECT_EQ(kernel.detail().block, block);
  }
  EXPECT_EQ(status, TickStatus::emergency_stop);
  EXPECT_NE(std::string(kernel.active_codes()).find("G90"), std::string::npos);
}

TEST(EmergencyStop, HasTheLastWord) {
  Kernel kernel(mill());
  kernel.feed("G21 G90\nG1 X1000 F6000\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 1000; ++i) {
    kernel.next(setpoint);
  }
  kernel.emergency_stop();
  while (kernel.next(setpoint) == TickStatus::running) {
  }
  const double at_mm = setpoint.position_mm[0];
  kernel.resume();
  kernel.stop();
  EXPECT_EQ(kernel.next(setpoint), TickStatus::emergency_stop);
  EXPECT_EQ(setpoint.position_mm[0], at_mm);
  EXPECT_FALSE(kernel.fault());
}

}  // namespace
}  // namespace kerf::test
