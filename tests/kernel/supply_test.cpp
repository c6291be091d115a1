// What the kernel does where its supply fails: no more text, no limits, a stop after the last byte.
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using interp::Setpoint;
using interp::TickStatus;

std::int64_t ticks_to_the_end(Kernel& kernel, Setpoint& setpoint) {
  std::int64_t ticks = 0;
  while (kernel.next(setpoint) == TickStatus::running && ticks < 100'000) {
    ++ticks;
  }
  return ticks;
}

struct Starving {
  double at_mm = 0.0;  // X where the text has run out
  std::string text;    // that comes then
  double end_mm = 0.0;
};

// F3000 is in force.
void expect_a_rest(Kernel& kernel, const Starving& wanted) {
  TickChecker checker(mill().limits, true);
  Setpoint setpoint;
  int starved = 0;
  for (int i = 0; i < 3000 && starved < 50; ++i) {
    starved += kernel.next(setpoint) == TickStatus::starved ? 1 : 0;
    checker.add({.setpoint = setpoint, .feedrate_mm_s = 50.0});
  }
  EXPECT_EQ(starved, 50);
  EXPECT_EQ(setpoint.position_mm[0], wanted.at_mm);
  kernel.feed(wanted.text);
  kernel.finish();
  for (TickStatus status = TickStatus::running; status == TickStatus::running;) {
    status = kernel.next(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = 50.0});
  }
  EXPECT_EQ(checker.complaint(), "");
  EXPECT_EQ(setpoint.position_mm[0], wanted.end_mm);
}

TEST(Stop, WorksInAProgramThatEndsWithItsLastByte) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1000 F6000\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(kernel.next(setpoint), TickStatus::running);
  }
  kernel.stop();
  EXPECT_LE(ticks_to_the_end(kernel, setpoint), 1200);
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_EQ(setpoint.line, 1U);
}

Setpoint next_of(Kernel& kernel, int ticks, TickStatus last) {
  Setpoint setpoint;
  TickStatus status = TickStatus::failed;
  for (int i = 0; i < ticks; ++i) {
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, last);
  return setpoint;
}

// A caller with one thread feeds where it starves.
TEST(Kernel, StarvesBehindAnAnsweredWaitWhereTheTextStopsComing) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90 G1 X1 F600\nM0\n");
  next_of(kernel, 1000, TickStatus::waiting);
  kernel.resume();
  next_of(kernel, 100, TickStatus::starved);
  kernel.feed("G1 X2\nM2\n");
  kernel.finish();
  EXPECT_EQ(next_of(kernel, 1000, TickStatus::finished).position_mm[0], 2.0);
}

TEST(Kernel, StarvesBehindAHoldWhereTheTextStopsComing) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1 F600\n");
  next_of(kernel, 1000, TickStatus::starved);
  kernel.hold();
  next_of(kernel, 100, TickStatus::held);
  kernel.resume();
  next_of(kernel, 100, TickStatus::starved);
  kernel.feed("G1 X2\nM2\n");
  kernel.finish();
  EXPECT_EQ(next_of(kernel, 1000, TickStatus::finished).position_mm[0], 2.0);
}

TEST(Kernel, KeepsNothingOfWhatComesBehindTheEnd) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1 F600\nM2\n");
  next_of(kernel, 1000, TickStatus::finished);
  kernel.feed("G1 X2 F-1\nsomething\n");
  kernel.finish();
  next_of(kernel, 10, TickStatus::finished);
  EXPECT_FALSE(kernel.has_errors());
}

TEST(Stop, DoesNothingOnceTheProgramHasEnded) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1 F6000\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  ticks_to_the_end(kernel, setpoint);
  kernel.stop();
  EXPECT_EQ(kernel.next(setpoint), TickStatus::finished);
  EXPECT_EQ(setpoint.position_mm[0], 1.0);
}

TEST(Kernel, StarvesAtRestWhereTheTextStopsComing) {
  Kernel kernel(mill(), {.window_blocks = 4});
  std::string text = "G21 G90 F3000\n";
  for (int i = 1; i <= 11; ++i) {
    text += "G1 X" + std::to_string(2 * i) + "\n";
  }
  kernel.feed(text);
  expect_a_rest(kernel, {.at_mm = 22.0, .text = "G1 X40\nM2\n", .end_mm = 40.0});
}

TEST(Kernel, StarvesAtRestBehindExactLinesThatGoOnStraight) {
  Kernel kernel(mill());
  std::string text = "G21 G90 G61 F3000\n";
  for (int i = 1; i <= 110; ++i) {
    text += "G1 X" + std::to_string(0.2 * i) + "\n";
  }
  kernel.feed(text);
  expect_a_rest(kernel, {.at_mm = 22.0, .text = "G1 X22.1\nX40\nM2\n", .end_mm = 40.0});
}

TEST(Kernel, StarvesAtRestBehindADwellAndResumesWithoutAJump) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X10 F3000\nG4 P0.01\n");
  expect_a_rest(kernel, {.at_mm = 10.0, .text = "X20\nM2\n", .end_mm = 20.0});
}

TEST(Kernel, RefusesToMoveAMachineWithoutLimits) {
  Kernel kernel(MachineSettings{});
  kernel.feed("G21 G90 G0 X10\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  ticks_to_the_end(kernel, setpoint);
  EXPECT_EQ(setpoint.position_mm[0], 0.0);
  ASSERT_TRUE(kernel.has_errors());
  EXPECT_EQ(
      kernel.diagnostics().back().message,
      "path.max_velocity_mm_s: nothing bounds the velocity, expected a limit here or in every "
      "axis");
}

}  // namespace
}  // namespace kerf::test
