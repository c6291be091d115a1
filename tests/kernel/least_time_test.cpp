// The time that a program takes at the least, against what is planned.
#include "kernel/least_time.hpp"

#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "interp/setpoint.hpp"
#include "kernel/reader_options.hpp"
#include "parser/program_reader.hpp"
#include "smoothing/segment_builder.hpp"

namespace kerf::test {
namespace {

LeastTime least_time(const std::string& text, const MachineSettings& settings) {
  parser::ProgramReader reader(reader_options(settings, {}));
  reader.feed(text);
  reader.finish();
  LeastTime time(settings.limits, event_time_settings(settings, {}));
  std::vector<smoothing::PathSegment> parts;
  for (parser::Move move; reader.next(move); parts.clear()) {
    EXPECT_TRUE(smoothing::append_segments(move, parts).has_value());
    time.add(move, parts);
  }
  EXPECT_FALSE(reader.has_errors());
  return time;
}

double least_time_s(const std::string& text, const MachineSettings& settings) {
  return least_time(text, settings).seconds();
}

double planned_time_s(const std::string& text, const MachineSettings& settings) {
  Kernel kernel(settings);
  kernel.feed(text);
  kernel.finish();
  interp::Setpoint setpoint;
  while (kernel.next(setpoint) == interp::TickStatus::running) {
  }
  EXPECT_FALSE(kernel.has_errors());
  return static_cast<double>(setpoint.tick) * settings.limits.period_s;
}

TEST(LeastTime, IsLengthOverFeedrateAndTheDwells) {
  const MachineSettings settings = default_machine();
  EXPECT_DOUBLE_EQ(
      least_time_s("G21 G90 G61\nG1 X10 F60\nG4 P2.5\nM0\nG3 X-10 I-10 F120\nM2\n", settings),
      10.0 + 2.5 + 3.14159265358979323846 * 10.0 / 2.0);
}

// An operator may be faster with a tool, and M66 may be answered at once.
TEST(LeastTime, KnowsWhatTheMachineFileSaysOfRestsAndDoesNotCountOnIt) {
  MachineSettings settings = default_machine();
  settings.program.tool_change_s = 7.0;
  settings.program.spindle_start_s = 3.0;
  const LeastTime time = least_time(
      "G21 G90 G61\nS1000 M3\nS2000\nG1 X10 F60\nG4 P2.5\nT1 M6\nM3\nM66 P1 L3 Q60\nX0\nM2\n",
      settings);
  EXPECT_DOUBLE_EQ(time.nominal().motion_s, 20.0);
  EXPECT_DOUBLE_EQ(time.nominal().rest_s, 3.0 + 2.5 + 7.0 + 3.0);
  constexpr double kBehindAnswer_s = 0.05 + 0.001;  // what follows is planned in, and a tick
  EXPECT_NEAR(time.seconds(), 20.0 + 2.5 + 60.0 + kBehindAnswer_s, 1e-9);
}

TEST(LeastTime, OfARapidIsThatOfTheMachine) {
  MachineSettings settings;
  settings.limits.path.velocity_mm_s = 50.0;
  EXPECT_DOUBLE_EQ(least_time_s("G0 X100\nM2\n", settings), 2.0);
  settings.limits.path.velocity_mm_s = lookahead::kUnbounded;
  for (auto& axis : settings.limits.axes) {
    axis.velocity_mm_s = 20.0;
  }
  EXPECT_DOUBLE_EQ(least_time_s("G0 X100 Y100 Z100\nM2\n", settings), 5.0);
}

// A corner within P saves at most 13 P of each of its lines.
TEST(LeastTime, OfLongLinesIsHardlyLessUnderATightTolerance) {
  const double exact_s = 20.0;
  const double min_s = least_time_s("G64 P0.01 Q0.01\nG1 X10 F60\nY10\nM2\n", default_machine());
  EXPECT_LT(min_s, exact_s);
  EXPECT_GT(min_s, 0.98 * exact_s);
}

TEST(LeastTime, IsNeverMoreThanThePlanTakes) {
  const MachineSettings settings = default_machine();
  for (const char* mode : {"", "G61\n", "G61.1\n", "G64 P0.2 Q0.1\n", "G64 P5 Q2\n"}) {
    for (const char* path :
         {"G1 F6000 X10\nY10\nX0\nY0\nM2\n", "G0 X40\nX0.5 Y8\nX40 Y16\nG2 X0 I-20 F3000\nM2\n",
          "G1 F3000 X1 Y1\nX2 Y-1\nX3 Y1\nX4 Y-1\nX5 Y1\nX6 Y-1\nM2\n"}) {
      const std::string text = std::string("G21 G90\n") + mode + path;
      EXPECT_LE(least_time_s(text, settings), planned_time_s(text, settings)) << text;
    }
  }
}

}  // namespace
}  // namespace kerf::test
