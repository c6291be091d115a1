// A, B, C, U, V, W in whole programs: in step with the path, within their limits, exact at the end.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/kernel.hpp>

#include "diagnostics/errors/pages.hpp"
#include "machine/simulated_table.hpp"
#include "parser/text/letters.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

constexpr double kRadPerDegree = 3.14159265358979323846 / 180.0;

// The mill with an axis A of 180 deg/s and a slow axis U.
MachineSettings mill_with_axes() {
  MachineSettings settings = mill();
  settings.program.extra_axes = parser::letters('A', 'U');
  settings.limits.extra[0] = {
      .velocity_mm_s = 3.0, .acceleration_mm_s2 = 30.0, .jerk_mm_s3 = 600.0};
  settings.limits.extra[3] = {
      .velocity_mm_s = 20.0, .acceleration_mm_s2 = 200.0, .jerk_mm_s3 = 4e3};
  settings.table.extra[0] = {.min_rad_mm = -10.0, .max_rad_mm = 10.0};
  return settings;
}

struct Motion {
  std::vector<Setpoint> ticks;
  std::string complaint;
};

// Until its end, or brought to rest from `stop_tick` on.
Motion run(const std::string& text, std::int64_t stop_tick = -1,
           const MachineSettings& settings = mill_with_axes()) {
  Kernel kernel(settings);
  kernel.feed(text + "\nM2\n");
  kernel.finish();
  TickChecker checker(settings.limits, true);
  Motion result;
  TickStatus status = TickStatus::running;
  for (std::int64_t i = 0; status == TickStatus::running && i < kMaxTicks; ++i) {
    if (i == stop_tick) {
      kernel.stop();
    }
    status = kernel.next(result.ticks.emplace_back());
    checker.add({.setpoint = result.ticks.back(), .feedrate_mm_s = 150.0});
  }
  result.complaint = checker.complaint();
  const bool ended = status == TickStatus::finished || status == TickStatus::failed;
  result.complaint += ended ? "" : " did not finish";
  for (const auto& found : kernel.diagnostics()) {
    result.complaint += found.message;
  }
  return result;
}

double fastest(const std::vector<Setpoint>& ticks, std::size_t axis) {
  double v = 0.0;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    v = std::max(v,
                 std::abs(ticks[i].extra_rad_mm[axis] - ticks[i - 1].extra_rad_mm[axis]) / 0.001);
  }
  return v;
}

TEST(ExtraAxes, MoveInStepWithLinesAndArcs) {
  const Motion line = run("G1 X30 A60 U3 F6000");
  EXPECT_EQ(line.complaint, "");
  for (const Setpoint& tick : line.ticks) {
    EXPECT_NEAR(tick.extra_rad_mm[0], 60 * kRadPerDegree * tick.position_mm[0] / 30, 1e-12);
    EXPECT_NEAR(tick.extra_rad_mm[3], tick.position_mm[0] / 10, 1e-12);
  }
  EXPECT_EQ(line.ticks.back().extra_rad_mm[0], 60 * kRadPerDegree);
  EXPECT_EQ(line.ticks.back().extra_rad_mm[3], 3.0);
  const Motion helix = run("G3 X0 Y0 I10 Z5 A-90 F6000");
  EXPECT_EQ(helix.complaint, "");
  for (const Setpoint& tick : helix.ticks) {
    EXPECT_NEAR(tick.extra_rad_mm[0], -90 * kRadPerDegree * tick.position_mm[2] / 5, 1e-9);
  }
  EXPECT_EQ(helix.ticks.back().extra_rad_mm[0], -90 * kRadPerDegree);
}

TEST(ExtraAxes, BindThePathWhereTheyAreTheSlowest) {
  const Motion turning = run("G1 X1 A400 F6000");  // U and A far beyond what F would ask of them
  EXPECT_EQ(turning.complaint, "");
  EXPECT_NEAR(fastest(turning.ticks, 0), 3.0, 1e-6);
}

TEST(ExtraAxes, RunAloneAtTheirOwnFeedrate) {
  const Motion turning = run("G1 A180 F3600");  // 60 deg/s
  EXPECT_EQ(turning.complaint, "");
  EXPECT_NEAR(fastest(turning.ticks, 0), 60 * kRadPerDegree, 1e-9);
  EXPECT_EQ(turning.ticks.back().extra_rad_mm[0], 180 * kRadPerDegree);
  EXPECT_EQ(turning.ticks.back().s_mm, 0.0);
  EXPECT_EQ(turning.ticks.back().position_mm, (curves::Position{}));
  const Motion straight = run("G1 U20 A90 F600");
  EXPECT_EQ(straight.complaint, "");
  EXPECT_NEAR(fastest(straight.ticks, 3), 10.0, 1e-9);
  const Motion rapid = run("G0 A180");
  EXPECT_EQ(rapid.complaint, "");
  EXPECT_NEAR(fastest(rapid.ticks, 0), 3.0, 1e-6);
}

TEST(ExtraAxes, CountNothingToThePathWhereTheyMoveAlone) {
  const Motion whole = run("G1 X10 F6000\nG1 A90 F36000\nG4 P0.01\nG1 X20 F6000");
  EXPECT_EQ(whole.complaint, "");
  EXPECT_NEAR(whole.ticks.back().s_mm, 20.0, 1e-12);
  const bool ordered = std::is_sorted(whole.ticks.begin(), whole.ticks.end(),
                                      [](const auto& a, const auto& b) { return a.s_mm < b.s_mm; });
  EXPECT_TRUE(ordered);
}

TEST(ExtraAxes, PassJunctionsInMotionWhereTheirSlopeStays) {
  const Motion whole = run("G1 X20 A20 F3000\nX40 A40\nX60 A60");
  EXPECT_EQ(whole.complaint, "");
  const auto at = std::find_if(whole.ticks.begin(), whole.ticks.end(),
                               [](const Setpoint& tick) { return tick.position_mm[0] >= 20.0; });
  EXPECT_GT(at->v_mm_s, 40.0);
  const Motion turned = run("G1 X20 A20 F3000\nX40 A-40");
  EXPECT_EQ(turned.complaint, "");
  const auto back = std::find_if(turned.ticks.begin(), turned.ticks.end(),
                                 [](const Setpoint& tick) { return tick.position_mm[0] >= 20.0; });
  EXPECT_LT(back->v_mm_s, 1.0);
}

TEST(ExtraAxes, KeepTheirPlaceInDwellsAndAtStops) {
  const std::string text =
      "G1 X20 A60 F3000\nG4 P0.02\nA-60 F36000\nU10 F6000\nG2 X40 I10 A0 U0 F3000";
  const Motion whole = run(text);
  EXPECT_EQ(whole.complaint, "");
  for (std::int64_t tick = 1; tick < whole.ticks.back().tick; tick += 23) {
    const Motion stopped = run(text, tick);
    EXPECT_EQ(stopped.complaint, "") << tick;
    const Setpoint& last = stopped.ticks.back();
    EXPECT_EQ(last.v_mm_s, 0.0);
    const bool on_way = std::any_of(whole.ticks.begin(), whole.ticks.end(), [&](const Setpoint& t) {
      return std::abs(t.extra_rad_mm[0] - last.extra_rad_mm[0]) < 3.1e-3 &&
             std::abs(t.extra_rad_mm[3] - last.extra_rad_mm[3]) < 2.1e-2 &&
             std::abs(t.position_mm[0] - last.position_mm[0]) < 0.06;
    });
    EXPECT_TRUE(on_way) << tick;
  }
}

TEST(ExtraAxes, KeepTheirPlaceInBlendedCornersAndMergedLines) {
  const Motion motion =
      run("G64 P0.05 Q0.05 G1 Y5 A30 U-2 F3000\n"
          "X10\n"
          "Y15\n"
          "G2 X15 Y20 I5\n"
          "G1 Y25\n"
          "X15.1 Y25.01\nX15.2 Y25.03\nX15.3 Y25.06\nX15.4 Y25.1\nX15.5 Y25.15\n"
          "M62 P1 X30\n"
          "Y0");
  EXPECT_EQ(motion.complaint, "");
  for (const Setpoint& tick : motion.ticks) {
    if (tick.line > 2) {
      ASSERT_EQ(tick.extra_rad_mm[0], 30.0 * kRadPerDegree) << "tick " << tick.tick;
      ASSERT_EQ(tick.extra_rad_mm[3], -2.0) << "tick " << tick.tick;
    }
  }
}

TEST(ExtraAxes, AreCheckedForTheirTravelBeforeTheStart) {
  std::string text = "G1 X1 A5 F100\nG0 A700\nM2\n";
  const CheckReport report = check_program(
      [&text, read = false]() mutable {
        const std::string_view piece = read ? std::string_view{} : std::string_view(text);
        read = true;
        return piece;
      },
      mill_with_axes());
  ASSERT_EQ(report.limit_faults.size(), 1U);
  EXPECT_EQ(report.limit_faults[0].source.line, 2U);
  EXPECT_EQ(report.limit_faults[0].message,
            "a goes 127.042 deg beyond its upper limit of 572.958 deg");
  EXPECT_NEAR(report.extra_extents.max_rad_mm[0], 700 * kRadPerDegree, 1e-12);
  EXPECT_EQ(report.extra_extents.min_rad_mm[0], 0.0);
}

TEST(ExtraAxes, AreCheckedForTheirTravelAtEveryTick) {
  machine::SimulatedTable table(mill_with_axes().table);
  table.enable({});
  Setpoint setpoint;
  setpoint.extra_rad_mm[0] = 9.0;
  table.write(setpoint);
  EXPECT_EQ(table.read().fault, machine::DriveFault::none);
  setpoint.extra_rad_mm[0] = 10.1;
  table.write(setpoint);
  EXPECT_EQ(table.read().fault, machine::DriveFault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 3);
  table.enable({});
  setpoint.extra_rad_mm = {};
  setpoint.extra_rad_mm[5] = std::nan("");
  table.write(setpoint);
  EXPECT_EQ(table.read().fault, machine::DriveFault::not_finite);
  EXPECT_EQ(table.read().fault_axis, 8);
}

TEST(ExtraAxes, AreRefusedWhereTheMachineHasNoLimitsOfThem) {
  MachineSettings settings = mill_with_axes();
  settings.limits.extra = {};
  EXPECT_EQ(run("G0 A10", -1, settings).complaint,
            "axes.a.max_velocity_deg_s: expected a limit, which this axis must have");
}

TEST(ExtraAxes, BeginWhereTheCallerSays) {
  Kernel kernel(mill_with_axes(), {.start_extra_rad_mm = {0.5}});
  kernel.feed("G91 G0 A10\nM2\n");
  kernel.finish();
  const auto ticks = rest_of(kernel);
  EXPECT_EQ(ticks.front().extra_rad_mm[0], 0.5);
  EXPECT_NEAR(ticks.back().extra_rad_mm[0], 0.5 + 10 * kRadPerDegree, 1e-15);
}

}  // namespace
}  // namespace kerf::test
