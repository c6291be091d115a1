// left_s() against what the run then takes.
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

// What is said of the time that is left at each tick of the text's run.
std::vector<double> said_left_s(const std::string& text,
                                const std::function<void(Kernel&, std::size_t tick)>& command,
                                const MachineSettings& machine = default_machine()) {
  bool read = false;
  const auto whole_text = [&]() -> std::string_view {
    return std::exchange(read, true) ? std::string_view() : std::string_view(text);
  };
  Kernel kernel(machine,
                {.tells_operator = true, .nominal = check_program(whole_text, machine).nominal});
  kernel.feed(text);
  kernel.finish();
  std::vector<double> said_s;
  Setpoint setpoint;
  for (auto status = TickStatus::running; status == TickStatus::running;) {
    command(kernel, said_s.size());
    kernel.plan();
    status = kernel.tick(setpoint);
    said_s.push_back(kernel.left_s().value_or(0.0));
  }
  return said_s;
}

// Found with a client: while the tool comes down to an override of a tenth it is faster than that,
// and the rest was said to be a quarter shorter.
TEST(TimeLeft, IsRightBehindALowOverride) {
  const std::vector<double> said_s = said_left_s("G21 G90 G61\nG1 X200 F3000\nG1 X0 Y30\nM2\n",
                                                 [](Kernel& kernel, std::size_t tick) {
                                                   if (tick == 1000) {
                                                     kernel.set_overrides({.feed = 0.1});
                                                   }
                                                 });
  for (const std::size_t tick : {1030U, 1100U, 1500U, 3000U, 20'000U}) {
    const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
    EXPECT_NEAR(said_s.at(tick), left_s, 0.04 * left_s) << "tick " << tick;
  }
}

// A dwell was over at its begin, and then it made all motion seem slower than it is.
TEST(TimeLeft, IsRightInADwellAndBehindIt) {
  const std::vector<double> said_s =
      said_left_s("G21 G90 G61\nG4 P5\nG1 X200 F3000\nG4 P3\nG1 X0\nG1 X50 F1500\nG4 P2\nM2\n",
                  [](Kernel& /*kernel*/, std::size_t /*tick*/) {});
  for (std::size_t tick = 1; tick < said_s.size(); tick += 250) {
    const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
    EXPECT_NEAR(said_s.at(tick), left_s, 0.02 * left_s + 0.1) << "tick " << tick;
  }
}

// Found with a client: the start of a spindle was taken for slow motion, and of 31 s 355 were said.
TEST(TimeLeft, IsRightWhereSpindleAndToolChangeTakeTime) {
  MachineSettings machine = default_machine();
  machine.program.spindle_start_s = 5.0;
  machine.program.tool_change_s = 8.0;
  const std::vector<double> said_s = said_left_s(
      "G21 G90 G61\nS1000 M3\nG1 X200 F3000\nX0\nT1 M6\nM3\nG1 X200\nM2\n",
      [](Kernel& /*kernel*/, std::size_t /*tick*/) {}, machine);
  ASSERT_GT(said_s.size(), 30'000U);
  for (std::size_t tick = 1; tick < said_s.size(); tick += 250) {
    const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
    EXPECT_NEAR(said_s.at(tick), left_s, 0.02 * left_s + 0.15) << "tick " << tick;
  }
}

// Found with a client: what is not read yet was thought to dwell ten times as long.
TEST(TimeLeft, CountsADwellInFullUnderALowOverride) {
  Kernel kernel(default_machine(), {.waits = true,
                                    .tells_operator = true,
                                    .nominal = NominalTime{.motion_s = 2.0, .rest_s = 30.0}});
  kernel.feed("G21 G90 G61\nG1 X50 F3000\nM0\nG4 P30\nG1 X0\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  auto status = TickStatus::running;
  for (int i = 0; i < 5000 && status == TickStatus::running; ++i) {
    kernel.plan();
    status = kernel.tick(setpoint);
  }
  ASSERT_EQ(status, TickStatus::waiting);
  for (const double feed : {1.0, 0.5, 0.1, 2.0}) {
    kernel.set_overrides({.feed = feed});
    kernel.plan();
    kernel.tick(setpoint);
    EXPECT_NEAR(kernel.left_s().value_or(0.0), 30.0 + 1.0 / feed, 0.1 + 0.1 / feed) << feed;
  }
}

// Found with clients: rapids, and what M49 keeps, were divided by the feed override too, so 48 s
// were said to be left of 11, and a spindle override did not count before a second of motion.
TEST(TimeLeft, DividesOnlyWhatAnOverrideSlows) {
  std::string rapids = "G21 G90 G61\nG1 X20 F3000\n";
  for (int i = 0; i < 6; ++i) {
    rapids += i % 2 == 0 ? "G0 X400\n" : "G0 X20\n";
  }
  const std::string per_revolution = "G21 G90 G61 G95 S1000 M3\nG1 X200 F1\nX0\nM2\n";
  struct Case {
    std::string text;
    Overrides overrides;
  };
  for (const Case& one :
       {Case{rapids + "M2\n", {.feed = 0.2}}, Case{rapids + "M2\n", {.rapid = 0.25}},
        Case{"G21 G90 G61 M49\nG1 X200 F3000\nX0\nM2\n", {.feed = 0.2}},
        Case{per_revolution, {.spindle = 0.5}}, Case{per_revolution, {.feed = 0.5, .spindle = 0.5}},
        Case{"G21 G90 G61 M50 P0\n" + per_revolution, {.feed = 0.5, .spindle = 2.0}},
        Case{"G21 G90 G61 M49\n" + per_revolution, {.feed = 0.5, .spindle = 0.5}}}) {
    const std::vector<double> said_s = said_left_s(one.text, [&](Kernel& kernel, std::size_t tick) {
      if (tick == 0) {
        kernel.set_overrides(one.overrides);
      }
    });
    for (std::size_t tick = 1; tick < said_s.size(); tick += 250) {
      const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
      EXPECT_NEAR(said_s.at(tick), left_s, 0.1 * left_s + 0.3) << one.text << "tick " << tick;
    }
  }
}

// Found by reading: a way that an axis A takes was divided by the feedrate of X, Y and Z. Of a
// fifth of it 482 s were said to be left of 31.
// M49 keeps the feed to X10; after M48 a feed of 0 holds.
TEST(TimeLeft, IsUnknownWhereAFeedOfZeroHoldsLater) {
  const NominalTime nominal{.motion_s = 6.0, .steady_s = 1.0};
  Kernel kernel(mill(), {.tells_operator = true, .nominal = nominal});
  kernel.feed("G21 G90 G61\nM49\nG1 X10 F600\nM48\nX60\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  const auto left_s = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      kernel.plan();
      kernel.tick(setpoint);
    }
    return kernel.left_s();
  };
  EXPECT_NEAR(left_s(100).value_or(0.0), 5.9, 0.1);
  kernel.set_overrides({.feed = 0.0});
  EXPECT_FALSE(left_s(100));
  EXPECT_GT(setpoint.v_mm_s, 9.9);
  kernel.set_overrides({});
  EXPECT_NEAR(left_s(100).value_or(0.0), 5.7, 0.1);
}

TEST(TimeLeft, IsRightWhereAnAxisThatTurnsIsTheSlowest) {
  MachineSettings machine = default_machine();
  machine.program.extra_axes = letter_bit('A');
  machine.limits.extra[0] = {.velocity_mm_s = 0.5, .acceleration_mm_s2 = 5.0, .jerk_mm_s3 = 50.0};
  for (const std::string turn : {"G0 A", "G1 F600 X0 A"}) {
    std::string text = "G21 G90 G61\n";
    for (int i = 1; i <= 5; ++i) {
      text += turn + std::to_string(180 * i) + "\nG1 X" + std::to_string(10 * i) + " F600\n";
    }
    const auto said_s = said_left_s(
        text + "G1 X0\nM2\n", [](Kernel&, std::size_t) {}, machine);
    for (std::size_t tick = 2000; tick < said_s.size(); tick += 1500) {
      const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
      // Ramps are not known before, and the little that X moves is judged by them, too.
      EXPECT_NEAR(said_s.at(tick), left_s, 0.25 * left_s + 0.5) << turn << ", tick " << tick;
    }
  }
}

// A raster of short and long moves: the first part is like the rest.
TEST(TimeLeft, FollowsTheOverride) {
  std::string text = "G21 G90 G64 P0.01 F6000\n";
  for (int i = 0; i < 60; ++i) {
    text +=
        "G1 X" + std::to_string(40 * (i % 2 == 0 ? 1 : 0)) + "\nY" + std::to_string(i % 30) + "\n";
  }
  text += "M2\n";
  bool read = false;
  const auto whole_text = [&]() -> std::string_view {
    return std::exchange(read, true) ? std::string_view() : std::string_view(text);
  };
  const NominalTime nominal = check_program(whole_text, mill()).nominal;
  const double period_s = mill().limits.period_s;
  const auto whole = ticks_of(text);
  Kernel kernel(mill(), {.tells_operator = true, .nominal = nominal});
  kernel.feed(text);
  kernel.finish();
  EXPECT_NEAR(*kernel.left_s(), nominal.motion_s, 1e-9);
  Setpoint setpoint;
  for (std::size_t tick = 0; tick < whole.size() - 1; ++tick) {
    kernel.plan();
    kernel.tick(setpoint);
    if (tick % 997 == 0 && tick > 4000) {
      const double left_s = static_cast<double>(whole.size() - tick) * period_s;
      EXPECT_NEAR(*kernel.left_s(), left_s, 0.1 * left_s + 0.1) << "tick " << tick;
    }
  }
  Kernel half(mill(), {.tells_operator = true, .nominal = nominal});
  half.set_overrides({.feed = 0.5});
  half.feed(text);
  half.finish();
  EXPECT_NEAR(*half.left_s(), 2.0 * nominal.motion_s, 1e-9);
  half.set_overrides({.feed = 0.0});
  half.plan();
  EXPECT_FALSE(half.left_s());
  EXPECT_FALSE(Kernel(mill(), {.tells_operator = true}).left_s()) << "nobody knows";
}

}  // namespace
}  // namespace kerf::test
