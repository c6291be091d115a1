// A program that starts at one of its blocks: nothing before it is run, and the rest is as it was.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "parser/text/letters.hpp"
#include "tests/kernel/run.hpp"

namespace kerf {
namespace {

using test::Setpoint;

// Two rectangles at 20 mm/s, of two tools; the comment says which block of the run a line is.
constexpr const char* kTwoTools =
    "G21 G90 G61 F1200\n"  // 1
    "T1 M6\n"              // 2
    "M3 S6000 M8\n"        // 3
    "M64 P3\n"             // 4
    "G0 X10 Y10 Z-5\n"     // 5
    "G1 Z-20\n"            // 6
    "X40\n"                // 7
    "Y30\n"                // 8
    "G0 Z-5\n"             // 9
    "T2 M6\n"              // 10
    "M4 S3000\n"           // 11
    "M7\n"                 // 12
    "G0 X60 Y10\n"         // 13
    "G1 Z-30 F600\n"       // 14
    "X80\n"                // 15
    "Y40\n"                // 16
    "M2\n";                // 17

MachineSettings machine_up_to(double top_mm) {
  MachineSettings settings = default_machine();
  settings.table.axes[2].travel.max_mm = top_mm;
  return settings;
}

std::vector<Setpoint> ticks_from(const std::string& text, std::uint64_t blocks_before,
                                 const MachineSettings& settings = default_machine(),
                                 KernelOptions options = {}) {
  options.start_in_program = StartInProgram{.blocks_before = blocks_before};
  Kernel kernel(settings, options);
  kernel.feed(text);
  kernel.finish();
  return test::rest_of(kernel);
}

const Setpoint& first_with(const std::vector<Setpoint>& ticks, bool (*is)(const Setpoint&)) {
  const auto found = std::ranges::find_if(ticks, is);
  EXPECT_NE(found, ticks.end());
  return found == ticks.end() ? ticks.back() : *found;
}

TEST(StartInMiddle, GoesUpThenOverThePlaceThenDownAtFeed) {
  const auto ticks = ticks_from(kTwoTools, 14, machine_up_to(25.0));
  // From X0 Y0 Z0 over the top at Z25 to X60 Y10 Z-30.
  double top_mm = 0.0;
  for (const Setpoint& tick : ticks) {
    const auto& [x, y, z] = tick.position_mm;
    top_mm = std::max(top_mm, z);
    const bool goes_up = x == 0.0 && y == 0.0;
    const bool goes_over = std::abs(z - 25.0) < 1e-9;
    const bool goes_down = std::abs(x - 60.0) < 1e-9 && std::abs(y - 10.0) < 1e-9;
    const bool is_on_path = std::abs(z + 30.0) < 1e-9;
    EXPECT_TRUE(goes_up || goes_over || goes_down || is_on_path) << x << " " << y << " " << z;
    if (goes_down && z < 24.9 && z > -29.9) {
      EXPECT_FALSE(tick.rapid);
      EXPECT_LE(tick.v_mm_s, 10.0 + 1e-6);  // F600 is in force there
    }
  }
  EXPECT_NEAR(top_mm, 25.0, 1e-9);
  EXPECT_EQ(ticks.back().position_mm, (Position{80.0, 40.0, -30.0}));
}

TEST(StartInMiddle, TheTravelsTopIsTheSafeHeightUnlessTheMachineFileSaysLess) {
  MachineSettings settings = machine_up_to(25.0);
  settings.program.safe_z_mm = 5.0;
  const auto highest = [&] {
    const auto ticks = ticks_from(kTwoTools, 14, settings);
    return std::ranges::max(ticks, {}, [](const Setpoint& tick) { return tick.position_mm[2]; })
        .position_mm[2];
  };
  EXPECT_NEAR(highest(), 5.0, 1e-9);
  settings.program.safe_z_mm = 100.0;
  EXPECT_NEAR(highest(), 25.0, 1e-9);
  settings.table.axes[2].travel.max_mm = kUnbounded;
  settings.program.safe_z_mm = kUnbounded;
  EXPECT_NEAR(highest(), 0.0, 1e-9);  // where the tool has been
}

TEST(StartInMiddle, WithoutAnyItGoesAsHighAsTheTopOfAnArc) {
  MachineSettings settings = machine_up_to(kUnbounded);
  const auto ticks =
      ticks_from("G21 G90 G61 G18 F1200\nG1 X10\nG3 X30 I10\nG1 X40\nX50\nM2\n", 4, settings);
  const auto top = std::ranges::max(ticks, {}, [](const Setpoint& t) { return t.position_mm[2]; });
  EXPECT_NEAR(top.position_mm[2], 10.0, 1e-6);
}

TEST(StartInMiddle, TheMachineFileNamesTheSafeHeight) {
  const std::string limits =
      "[path]\nmax_velocity_mm_s = 1\nmax_acceleration_mm_s2 = 1\nmax_jerk_mm_s3 = 1\n[program]\n";
  EXPECT_EQ(parse_machine_file(limits)->program.safe_z_mm, kUnbounded);
  EXPECT_EQ(parse_machine_file(limits + "safe_z_mm = 40\n")->program.safe_z_mm, 40.0);
  EXPECT_FALSE(parse_machine_file(limits + "safe_z_mm = 1e7\n"));
}

TEST(StartInMiddle, ToolSpindleAndCoolantAreThereBeforeTheToolGoesDown) {
  const auto ticks = ticks_from(kTwoTools, 14, machine_up_to(25.0));
  const auto& down = first_with(ticks, [](const Setpoint& tick) {
    return tick.position_mm[0] > 59.9 && tick.position_mm[2] < 24.9;
  });
  EXPECT_EQ(down.outputs.tool, 2);
  EXPECT_NEAR(down.outputs.spindle_rad_s, -3000.0 * 2.0 * M_PI / 60.0, 1e-9);
  EXPECT_TRUE(down.outputs.mist);
  EXPECT_TRUE(down.outputs.flood);
  EXPECT_EQ(down.outputs.digital, 1U << 3U);
  const auto& turned =
      first_with(ticks, [](const Setpoint& tick) { return tick.outputs.spindle_rad_s != 0.0; });
  EXPECT_NEAR(turned.position_mm[2], 25.0, 1e-9);
  EXPECT_EQ(turned.outputs.tool, 2);
  // The first tool was needed by nothing that is run.
  EXPECT_TRUE(std::ranges::none_of(ticks, [](const Setpoint& t) { return t.outputs.tool == 1; }));
}

// How long the tool rests with a spindle that turns, on its way to the start.
double rest_s(const std::vector<Setpoint>& ticks) {
  const auto rests = [](const Setpoint& tick) {
    return tick.outputs.spindle_rad_s != 0.0 && tick.v_mm_s == 0.0;
  };
  const auto begin = std::ranges::find_if(ticks, rests);
  return static_cast<double>(std::find_if_not(begin, ticks.end(), rests) - begin) *
         default_machine().limits.period_s;
}

TEST(StartInMiddle, TheToolWaitsForTheSpindleAsBehindM3) {
  MachineSettings settings = machine_up_to(25.0);
  settings.program.waits_for_spindle = true;
  settings.simulation.spindle_rad_s2 = 100.0;
  constexpr double kTime_s = 3000.0 * 2.0 * M_PI / 60.0 / 100.0;
  constexpr double kBehindAnswer_s = 0.05;  // what follows is planned in
  EXPECT_NEAR(rest_s(ticks_from(kTwoTools, 14, settings)), kTime_s + kBehindAnswer_s, 0.01);
}

TEST(StartInMiddle, TheSpindleStartsAlsoWhereATapTurnedItLast) {
  MachineSettings settings = machine_up_to(25.0);
  settings.program.spindle_start_s = 3.0;
  const std::string text =
      "G21 G90 G94 G61 F300\nG0 Z10\nS300 M3\nG84 X0 Y0 Z-2 R2\nG80\nG0 X20\nG1 Z-1\nX40\nM2\n";
  EXPECT_NEAR(rest_s(ticks_from(text, 7, settings)), 3.0, 0.01);
}

// Of A alone F is in degrees a minute: 3600 are 1.05 rad/s.
TEST(StartInMiddle, TheFeedrateOfARotaryAxisIsNotThatOfTheWayDown) {
  MachineSettings settings = machine_up_to(25.0);
  settings.program.extra_axes = parser::letters('A');
  settings.limits.extra[0] = {
      .velocity_mm_s = 6.0, .acceleration_mm_s2 = 60.0, .jerk_mm_s3 = 600.0};
  const std::string text = "G21 G90 G61\nG0 X10 Z-50\nG1 X20 F600\nA90 F3600\nX30 F600\nM2\n";
  for (const std::uint64_t blocks_before : {3U, 4U}) {
    const auto ticks = ticks_from(text, blocks_before, settings);
    const auto fastest = std::ranges::max(ticks, {}, [](const Setpoint& tick) {
      return tick.rapid || tick.position_mm[2] > 24.0 ? 0.0 : tick.v_mm_s;
    });
    EXPECT_NEAR(fastest.v_mm_s, 10.0, 1e-6) << blocks_before;
    EXPECT_LT(ticks.size(), 12000U) << blocks_before;
  }
}

TEST(StartInMiddle, AtItsFirstBlockAProgramIsTheWhole) {
  const auto whole = test::ticks_of("G21 G90 G61 F1200\nG1 X10\nY10\nM2\n");
  const auto started = ticks_from("G21 G90 G61 F1200\nG1 X10\nY10\nM2\n", 0, test::mill());
  // But for the way up to the travel's top and back.
  EXPECT_EQ(started.back().position_mm, whole.back().position_mm);
  EXPECT_EQ(started.back().outputs, whole.back().outputs);
}

TEST(StartInMiddle, WaitsForAnAnswerBeforeTheToolLeavesItsPlace) {
  KernelOptions options{.waits = true,
                        .start_in_program = StartInProgram{.blocks_before = 14, .waits = true}};
  Kernel kernel(machine_up_to(25.0), options);
  kernel.feed(kTwoTools);
  kernel.finish();
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  for (int i = 0; i < 100; ++i) {
    status = kernel.next(setpoint);
    EXPECT_EQ(setpoint.position_mm, (Position{}));
  }
  EXPECT_EQ(status, TickStatus::waiting);
  kernel.resume();
  for (int i = 0; i < 100; ++i) {
    kernel.next(setpoint);
  }
  EXPECT_GT(setpoint.position_mm[2], 0.0);
}

TEST(StartInMiddle, SaysNothingOfWhatTheBlocksBeforeSay) {
  const std::string text = "G21 G90 G61 F600\n(MSG, one)\nG1 X1\nX2\nX3\n(MSG, two)\nX4\nM2\n";
  Kernel kernel(default_machine(),
                {.tells_operator = true, .start_in_program = StartInProgram{.blocks_before = 4}});
  kernel.feed(text);
  kernel.finish();
  static_cast<void>(test::rest_of(kernel));
  kernel.plan();
  const auto said = kernel.take_messages();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said.front().text, "two");
}

}  // namespace
}  // namespace kerf
