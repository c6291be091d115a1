// Messages and codes reach the operator as the tool comes to their blocks, not as text is read.
#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

struct Heard {
  std::string text;
  std::uint32_t line = 0;  // the tool's
  double x_mm = 0.0;
};

struct NotedRun {
  std::vector<Heard> messages;
  std::vector<std::pair<double, std::string>> codes;  // from which X on, and what was new in them
  std::vector<Setpoint> ticks;
};

NotedRun run_noted(const std::string& text, KernelOptions options = {}) {
  options.tells_operator = true;
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  NotedRun run;
  TickStatus status = TickStatus::running;
  std::string codes;
  while (status != TickStatus::finished && run.ticks.size() < kMaxTicks) {
    Setpoint setpoint;
    kernel.plan();
    status = kernel.tick(setpoint);
    run.ticks.push_back(setpoint);
    if (status == TickStatus::waiting) {
      kernel.plan();
    }
    for (const ProgramMessage& message : kernel.take_messages()) {
      run.messages.push_back(
          {.text = message.text, .line = setpoint.line, .x_mm = setpoint.position_mm[0]});
    }
    if (status == TickStatus::waiting) {
      kernel.resume();
    }
    if (kernel.active_codes() != codes) {
      codes = kernel.active_codes();
      run.codes.emplace_back(setpoint.position_mm[0], codes);
    }
  }
  kernel.plan();
  for (const ProgramMessage& message : kernel.take_messages()) {
    run.messages.push_back({.text = message.text, .x_mm = run.ticks.back().position_mm[0]});
  }
  EXPECT_EQ(status, TickStatus::finished);
  return run;
}

constexpr double kTick_mm =
    0.2;  // more than a tick's way at F6000 and 1 ms, with the plan() behind

TEST(ProgramNotes, TellAMessageWhereTheToolComesToItsBlock) {
  const NotedRun run = run_noted(
      "G21 G90 F6000\n(MSG, first)\nG1 X10\n(MSG, second)\nX30\nX50 (MSG, third)\n(MSG, "
      "last)\nM2\n");
  ASSERT_EQ(run.messages.size(), 4);
  const std::vector<std::pair<std::string, double>> expected{
      {"first", 0.0}, {"second", 10.0}, {"third", 30.0}, {"last", 50.0}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(run.messages[i].text, expected[i].first);
    EXPECT_NEAR(run.messages[i].x_mm, expected[i].second, kTick_mm) << expected[i].first;
  }
}

// In runs of short lines that become one curve, too.
TEST(ProgramNotes, TellAMessageInTheMiddleOfAMergedRun) {
  std::string text = "G21 G90 G64 P0.01 Q0.01 F6000\nG1 X1\n";
  for (int i = 2; i <= 100; ++i) {
    text += (i == 60 ? "(MSG, here)\n" : "") + std::string("X") + std::to_string(i) + "\n";
  }
  const NotedRun run = run_noted(text + "M2\n");
  ASSERT_EQ(run.messages.size(), 1);
  EXPECT_NEAR(run.messages[0].x_mm, 59.0, kTick_mm);
}

// 30 ms before: then it is told before the wait is. From there to the rest a jerk of 50,000 mm/s3
// takes less than 0.3 mm.
TEST(ProgramNotes, TellAMessageBeforeAWaitRightBeforeTheToolIsThere) {
  const NotedRun run =
      run_noted("G21 G90 F6000\nG1 X10\n(MSG, tool 2 please)\nT2 M6\n(MSG, thank you)\nX30\nM2\n",
                {.waits = true});
  ASSERT_EQ(run.messages.size(), 2);
  EXPECT_GT(run.messages[0].x_mm, 9.7);
  EXPECT_LE(run.messages[0].x_mm, 10.0);
  EXPECT_NEAR(run.messages[1].x_mm, 10.0, kTick_mm);
}

TEST(ProgramNotes, TellAMessageBehindTheLastBlockOfAProgramWithoutAnEnd) {
  const NotedRun run = run_noted("G21 G90 F6000\nG1 X10\n(MSG, over)\n");
  ASSERT_EQ(run.messages.size(), 1);
  EXPECT_EQ(run.messages[0].x_mm, 10.0);
}

TEST(ProgramNotes, HaveTheCodesOfTheBlockThatTheToolIsAt) {
  const NotedRun run = run_noted("G21 G90 G61 F6000\nG1 X10\nG2 X20 I5\nG1 X40 M8\nM2\n");
  const auto has = [](const std::string& codes, const std::string& code) {
    return (" " + codes + " ").find(" " + code + " ") != std::string::npos;
  };
  for (const auto& [x_mm, codes] : run.codes) {
    if (x_mm > 0.2 && x_mm < 9.8) {
      EXPECT_TRUE(has(codes, "G1") && has(codes, "G61") && !has(codes, "M8")) << codes;
    } else if (x_mm > 10.2 && x_mm < 19.8) {
      EXPECT_TRUE(has(codes, "G2") && !has(codes, "M8")) << codes;
    } else if (x_mm > 20.2 && x_mm < 39.8) {
      EXPECT_TRUE(has(codes, "G1") && has(codes, "M8")) << codes;
    }
  }
  ASSERT_GE(run.codes.size(), 3);
  EXPECT_TRUE(has(run.codes[1].second, "G2")) << run.codes[1].second;
  EXPECT_NEAR(run.codes[1].first, 10.0, kTick_mm);
}

TEST(ProgramNotes, HaveFAsWrittenAndSAndTOfTheBlockThatTheToolIsAt) {
  KernelOptions options;
  options.tells_operator = true;
  Kernel kernel(mill(), options);
  kernel.feed("G20 G90 G61\nG0 X1\nG1 X2 F120.5 S9000 M3\nT7\nX3\nM6\nX4 F60\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  std::vector<std::pair<double, std::string>> words;
  for (auto status = TickStatus::running; status == TickStatus::running;) {
    kernel.plan();
    status = kernel.tick(setpoint);
    words.emplace_back(setpoint.position_mm[0] / 25.4, kernel.active_words());
  }
  const auto at = [&words](double x_inch) {
    return std::ranges::find_if(words, [=](const auto& one) { return one.first >= x_inch; })
        ->second;
  };
  EXPECT_EQ(at(0.5), "S0 T0");
  EXPECT_EQ(at(1.5), "F120.5 S9000 T0");
  EXPECT_EQ(at(2.5), "F120.5 S9000 T0") << "tool 7 is not in the spindle yet";
  EXPECT_EQ(at(3.5), "F60 S9000 T7");
}

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
TEST(ProgramNotes, KnowTheTimeThatIsLeftBehindALowOverride) {
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
TEST(ProgramNotes, KnowTheTimeThatIsLeftInADwellAndBehindIt) {
  const std::vector<double> said_s =
      said_left_s("G21 G90 G61\nG4 P5\nG1 X200 F3000\nG4 P3\nG1 X0\nG1 X50 F1500\nG4 P2\nM2\n",
                  [](Kernel& /*kernel*/, std::size_t /*tick*/) {});
  for (std::size_t tick = 1; tick < said_s.size(); tick += 250) {
    const double left_s = static_cast<double>(said_s.size() - tick) * 1e-3;
    EXPECT_NEAR(said_s.at(tick), left_s, 0.02 * left_s + 0.1) << "tick " << tick;
  }
}

// Found with a client: the start of a spindle was taken for slow motion, and of 31 s 355 were said.
TEST(ProgramNotes, KnowTheTimeThatIsLeftWhereSpindleAndToolChangeTakeTime) {
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
TEST(ProgramNotes, KnowThatADwellTakesNoLongerUnderALowOverride) {
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

// Found with a client: rapids, and what M49 keeps, were divided by the feed override too, so 48 s
// were said to be left of 11.
TEST(ProgramNotes, KnowTheTimeThatIsLeftOfWhatAnOverrideDoesNotSlow) {
  std::string rapids = "G21 G90 G61\nG1 X20 F3000\n";
  for (int i = 0; i < 6; ++i) {
    rapids += i % 2 == 0 ? "G0 X400\n" : "G0 X20\n";
  }
  struct Case {
    std::string text;
    Overrides overrides;
  };
  for (const Case& one :
       {Case{rapids + "M2\n", {.feed = 0.2}}, Case{rapids + "M2\n", {.rapid = 0.25}},
        Case{"G21 G90 G61 M49\nG1 X200 F3000\nX0\nM2\n", {.feed = 0.2}}}) {
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
TEST(ProgramNotes, KnowTheTimeThatIsLeftWhereAnAxisThatTurnsIsTheSlowest) {
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
TEST(ProgramNotes, KnowTheTimeThatIsLeftAndFollowTheOverride) {
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

TEST(ProgramNotes, ChangeNoTick) {
  const NotedRun run = run_noted(mixed_program());
  const auto plain = ticks_of(mixed_program());
  ASSERT_EQ(run.ticks.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    ASSERT_EQ(run.ticks[i].position_mm, plain[i].position_mm) << "tick " << i;
  }
}

}  // namespace
}  // namespace kerf::test
