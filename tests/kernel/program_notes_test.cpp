// Messages and codes reach the operator as the tool comes to their blocks, not as text is read.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
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

constexpr double kTick_mm = 0.2;  // more than a tick's way at F6000 and 1 ms, with the plan() after

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

TEST(ProgramNotes, TellAMessageWhereTheToolRestsBecauseTheTextIsLate) {
  Kernel kernel(mill(), {.tells_operator = true});
  kernel.feed("G21 G90 F6000\nG1 X10\n(MSG, one)\n");
  Setpoint setpoint;
  const auto messages_after = [&](int ticks) {
    for (int i = 0; i < ticks; ++i) {
      if (kernel.plan()) {
        kernel.plan_to_rest();
      }
      kernel.tick(setpoint);
    }
    return kernel.take_messages();
  };
  EXPECT_TRUE(messages_after(50).empty());
  const auto told = messages_after(500);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  ASSERT_EQ(told.size(), 1);
  EXPECT_EQ(told[0].text, "one");
  kernel.feed("(MSG, two)\nX20\nM2\n");
  kernel.finish();
  const auto more = messages_after(500);
  EXPECT_EQ(setpoint.position_mm[0], 20.0);
  ASSERT_EQ(more.size(), 1);
  EXPECT_EQ(more[0].text, "two");
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
