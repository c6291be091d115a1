// Spindle, coolant, tool and outputs reach the machine in step with the motion.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "machine/simulated_table.hpp"
#include "profiles/profile.hpp"

namespace {

using kerf::interp::Outputs;
using kerf::interp::Setpoint;
using kerf::interp::TickStatus;

constexpr double kTwoPi = 6.283185307179586477;

struct Tick {
  Setpoint setpoint;
  Outputs seen;  // by the simulated table
};

using kerf::profiles::ProfileKind;

// The S-curve's cruise is the programmed feedrate to the last digit.
std::vector<Tick> run(std::string_view program, ProfileKind kind = ProfileKind::s_curve) {
  const kerf::MachineSettings settings = kerf::default_machine();
  kerf::Kernel kernel(settings, {.profile = kerf::profiles::Profile(kind)});
  kerf::machine::SimulatedTable table(settings.table);
  table.enable({});
  kernel.feed(program);
  kernel.finish();
  std::vector<Tick> ticks;
  for (Setpoint setpoint; ticks.size() < 100'000;) {
    const TickStatus status = kernel.next(setpoint);
    table.write(setpoint);
    ticks.push_back({setpoint, table.read().outputs});
    if (status == TickStatus::finished) {
      break;
    }
  }
  EXPECT_FALSE(kernel.has_errors());
  return ticks;
}

// The first tick at which it is so.
const Setpoint& first(const std::vector<Tick>& ticks, const std::function<bool(const Tick&)>& is) {
  for (const Tick& tick : ticks) {
    if (is(tick)) {
      return tick.setpoint;
    }
  }
  ADD_FAILURE() << "it never is so";
  return ticks.back().setpoint;
}

TEST(OutputChanges, AtMotionComeAtTheJunctionWithoutARest) {
  const auto ticks = run("F600\nG1 X5\nM62 P3\nG1 X10\nM63 P3 \nM67 E2 Q1.5\nG1 X15\nM2\n");
  const Setpoint& on = first(ticks, [](const Tick& t) { return t.seen.digital == 8U; });
  const Setpoint& on_block = first(ticks, [](const Tick& t) { return t.setpoint.line == 4; });
  EXPECT_EQ(on.tick, on_block.tick);
  EXPECT_NEAR(on.v_mm_s, 10.0, 1e-9) << "the junction is passed at the feedrate";
  EXPECT_NEAR(on.position_mm[0], 5.0, 0.01) << "one tick at 10 mm/s";
  const Setpoint& off =
      first(ticks, [](const Tick& t) { return t.setpoint.line > 4 && t.seen.digital == 0U; });
  const Setpoint& next = first(ticks, [](const Tick& t) { return t.setpoint.line == 7; });
  EXPECT_EQ(off.tick, next.tick);
  EXPECT_NEAR(off.position_mm[0], 10.0, 0.01);
  EXPECT_EQ(first(ticks, [](const Tick& t) { return t.seen.analog[2] == 1.5; }).tick, next.tick);
}

TEST(OutputChanges, AtMotionComeWhereABlendTakesAllOfTheirBlock) {
  const auto ticks = run("G21 G90 G64 P0.2 Q0\nM62 P1\nG1 X0.02 F3000\nY5\nM2\n");
  EXPECT_EQ(first(ticks, [](const Tick& tick) { return tick.seen.digital == 2; }).tick, 0);
}

// A laser's power at every line of an engraving. Without it the circle is one curve.
TEST(OutputChanges, AtMotionLeaveMergedLinesAsFastAsTheyAre) {
  const auto circle = [](int lines_per_change) {
    std::string program = "G21 G90 G64 P0.01 Q0.01 F3000\n";
    for (int i = 0; i <= 200; ++i) {
      const double angle = kTwoPi * i / 200.0;
      program += lines_per_change > 0 && i % lines_per_change == 0
                     ? "M67 E0 Q" + std::to_string(i + 1) + "\n"
                     : "\n";
      program += "G1 X" + std::to_string(10.0 * std::cos(angle)) + " Y" +
                 std::to_string(10.0 * std::sin(angle)) + "\n";
    }
    return run(program + "M2\n", ProfileKind::time_optimal);
  };
  const auto plain = circle(0);
  for (const int step : {1, 5}) {
    const auto ticks = circle(step);
    EXPECT_LE(ticks.size(), plain.size() + 1);
    for (const Tick& tick : ticks) {
      const int line = (static_cast<int>(tick.setpoint.line) - 3) / 2;  // its number on the circle
      if (line > 0 && tick.setpoint.v_mm_s > 0.0) {
        ASSERT_EQ(tick.seen.analog[0], line / step * step + 1) << tick.setpoint.line;
      }
    }
  }
}

TEST(OutputChanges, AtMotionWaitForAMotionAcrossRests) {
  const auto ticks = run("F600\nG1 X5\nM62 P0\nG4 P0.5\nG1 X10\nM62 P1\nM2\n");
  const Setpoint& on = first(ticks, [](const Tick& t) { return t.seen.digital == 1U; });
  EXPECT_EQ(on.tick, first(ticks, [](const Tick& t) { return t.setpoint.line == 5; }).tick);
  for (const Tick& tick : ticks) {
    ASSERT_LE(tick.seen.digital, 1U) << "no motion follows M62 P1";
  }
}

TEST(OutputChanges, AtOnceComeWithTheToolAtRest) {
  const auto ticks =
      run("F600\nM3 S600\nG1 X5\nM8\nM64 P5\nG1 X10\nM65 P5 M4 S300\nM7\nG1 X15\nM9\nM2\n");
  EXPECT_NEAR(ticks.front().seen.spindle_rad_s, 10.0 * kTwoPi, 1e-9);
  const Setpoint& flood = first(ticks, [](const Tick& t) { return t.seen.flood; });
  EXPECT_EQ(flood.position_mm[0], 5.0);
  EXPECT_EQ(flood.v_mm_s, 0.0);
  EXPECT_EQ(flood.tick, first(ticks, [](const Tick& t) { return t.seen.digital == 32U; }).tick);
  const Setpoint& reversed = first(ticks, [](const Tick& t) { return t.seen.spindle_rad_s < 0.0; });
  EXPECT_EQ(reversed.position_mm[0], 10.0);
  EXPECT_NEAR(reversed.outputs.spindle_rad_s, -5.0 * kTwoPi, 1e-9);
  EXPECT_EQ(reversed.outputs.digital, 0U);
  EXPECT_TRUE(reversed.outputs.mist);
  const Setpoint& dry = first(ticks, [&](const Tick& t) {
    return t.setpoint.tick > reversed.tick && !t.seen.mist && !t.seen.flood;
  });
  EXPECT_EQ(dry.position_mm[0], 15.0);
}

TEST(OutputChanges, OfTheToolStopTheSpindle) {
  const auto ticks = run("M3 S600\nG0 X5\nT7 M6\nG0 X10\nM61 Q2\nM19 R90\nG0 X15\nM2\n");
  const Setpoint& changed = first(ticks, [](const Tick& t) { return t.seen.tool == 7; });
  EXPECT_EQ(changed.position_mm[0], 5.0);
  EXPECT_EQ(changed.outputs.spindle_rad_s, 0.0);
  EXPECT_EQ(first(ticks, [](const Tick& t) { return t.seen.tool == 2; }).position_mm[0], 10.0);
  const Setpoint& held = first(ticks, [](const Tick& t) { return t.seen.spindle_held; });
  EXPECT_NEAR(held.outputs.spindle_angle_rad, kTwoPi / 4.0, 1e-12);
}

TEST(OutputChanges, OfSurfaceSpeedFollowXTickByTick) {
  // 120 m/min is 2000 mm/s; at X30 that is 2000/30 rad/s. D300 holds it to 10 pi rad/s.
  const auto ticks = run("G0 X30\nG96 S120 M3\nG1 X-40 Y9 F6000\nG97 S60\nG0 X0\nM2\n");
  bool follows = false;
  for (const Tick& tick : ticks) {
    if (tick.setpoint.line == 3) {
      const double radius_mm = std::max(std::fabs(tick.setpoint.position_mm[0]), 1e-9);
      const double most = 1e5 / 60.0 * kTwoPi;
      ASSERT_NEAR(tick.seen.spindle_rad_s, std::min(2000.0 / radius_mm, most), 1e-9 * most);
      follows = true;
    }
  }
  EXPECT_TRUE(follows);
  const Setpoint& fixed = first(ticks, [](const Tick& t) { return t.setpoint.line == 5; });
  EXPECT_NEAR(fixed.outputs.spindle_rad_s, kTwoPi, 1e-9);

  const auto limited = run("G0 X100\nG96 S120 D300 M4\nG1 X20 F6000\nX0\nM2\n");
  for (const Tick& tick : limited) {
    if (tick.setpoint.line >= 3 && tick.setpoint.line <= 4) {
      const double x = tick.setpoint.position_mm[0];
      ASSERT_NEAR(tick.seen.spindle_rad_s, -(x > 2000.0 / (5 * kTwoPi) ? 2000.0 / x : 5 * kTwoPi),
                  1e-9);
    }
  }
}

TEST(OutputChanges, OfSurfaceSpeedFollowTheProgramsX) {
  const auto ticks =
      run("G10 L2 P1 X10 R90\nG96 S120 D100000 M3\nG1 X5 Y50 F6000\nG52 X-20\n"
          "G1 Y60\nM2\n");
  for (const Tick& tick : ticks) {
    if (tick.setpoint.line != 3 && tick.setpoint.line != 5) {
      continue;
    }
    // Turned by 90 degrees the program's X is the machine's Y.
    const double x = tick.setpoint.position_mm[1] + (tick.setpoint.line == 5 ? 20.0 : 0.0);
    ASSERT_NEAR(tick.seen.spindle_rad_s,
                std::min(2000.0 / std::max(std::fabs(x), 1e-9), 1e5 / 60.0 * kTwoPi), 1e-6)
        << tick.setpoint.line;
  }
}

TEST(OutputChanges, EndWithTheProgram) {
  const auto ticks = run("M3 S600 M8\nM64 P1\nG0 X5\nM2\n");
  EXPECT_EQ(ticks.back().seen.spindle_rad_s, 0.0);
  EXPECT_FALSE(ticks.back().seen.flood);
  EXPECT_EQ(ticks.back().seen.digital, 2U) << "outputs stay";
}

TEST(OutputChanges, ManyInARowAllCome) {
  std::string program;
  for (int i = 0; i < 5000; ++i) {
    program += "M68 E0 Q" + std::to_string(i) + "\nM62 P" + std::to_string(i % 64) + "\n";
  }
  const auto ticks = run(program + "G0 X1\nM2\n");
  EXPECT_EQ(ticks.back().seen.analog[0], 4999.0);
  EXPECT_EQ(ticks.back().seen.digital, ~std::uint64_t{0});
}

}  // namespace
