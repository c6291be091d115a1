// The kernel from text to ticks: pieces of text, repetition, errors, starvation, stops.
#include <algorithm>
#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <kerf/check.hpp>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

bool same_bits(const Setpoint& a, const Setpoint& b) {
  return a.tick == b.tick && a.line == b.line &&
         std::memcmp(&a.s_mm, &b.s_mm, sizeof a.s_mm) == 0 &&
         std::memcmp(&a.v_mm_s, &b.v_mm_s, sizeof a.v_mm_s) == 0 &&
         std::memcmp(&a.a_mm_s2, &b.a_mm_s2, sizeof a.a_mm_s2) == 0 &&
         std::memcmp(&a.j_mm_s3, &b.j_mm_s3, sizeof a.j_mm_s3) == 0 &&
         std::memcmp(&a.position_mm, &b.position_mm, sizeof a.position_mm) == 0 &&
         std::memcmp(&a.velocity_mm_s, &b.velocity_mm_s, sizeof a.velocity_mm_s) == 0 &&
         std::memcmp(&a.acceleration_mm_s2, &b.acceleration_mm_s2, sizeof a.acceleration_mm_s2) ==
             0;
}

void expect_same_bits(const std::vector<Setpoint>& a, const std::vector<Setpoint>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_TRUE(same_bits(a[i], b[i])) << "tick " << i;
  }
}

TEST(Kernel, GivesTheSameTicksToTheLastBitASecondTime) {
  for (const ProfileKind kind :
       {ProfileKind::s_curve, ProfileKind::sigmoid, ProfileKind::sine_series}) {
    const KernelOptions options{.profile = Profile{kind}};
    expect_same_bits(ticks_of(mixed_program(), options), ticks_of(mixed_program(), options));
  }
}

TEST(Kernel, GivesTheSameTicksHoweverTheTextIsCut) {
  const std::string text = mixed_program();
  const auto whole = ticks_of(text);
  for (const std::size_t size : {1U, 2U, 3U, 7U, 64U, 1000U}) {
    SCOPED_TRACE(size);
    Kernel kernel(mill());
    for (std::size_t at = 0; at < text.size(); at += size) {
      kernel.feed(std::string_view(text).substr(at, size));
    }
    kernel.finish();
    expect_same_bits(whole, rest_of(kernel));
  }
}

TEST(Kernel, GivesTheSameTicksWhenTextComesAsPlanAsksForIt) {
  const std::string text = mixed_program();
  Kernel kernel(mill());
  std::vector<Setpoint> ticks;
  std::size_t at = 0;
  for (auto status = TickStatus::running; status == TickStatus::running;) {
    while (kernel.plan()) {
      if (at < text.size()) {
        kernel.feed(std::string_view(text).substr(at, 5));
        at += 5;
      } else {
        kernel.finish();
      }
    }
    ticks.emplace_back();
    status = kernel.tick(ticks.back());
  }
  expect_same_bits(ticks_of(text), ticks);
}

TEST(Kernel, TellsRapidsFromOtherMotion) {
  const auto ticks = ticks_of("G21 G90\nG0 X1\nG1 X2 F100\nG4 P0.01\nG0 X4\nY1\nG1 X5\nM30\n");
  for (const Setpoint& setpoint : ticks) {
    if (setpoint.v_mm_s > 0.0) {
      EXPECT_EQ(setpoint.rapid, setpoint.line == 2 || setpoint.line == 5 || setpoint.line == 6)
          << "line " << setpoint.line;
    }
  }
}

TEST(Kernel, NumbersTicksFromZeroWithoutAGap) {
  const auto ticks = ticks_of(mixed_program());
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    ASSERT_EQ(ticks[i].tick, static_cast<std::int64_t>(i));
  }
}

TEST(Kernel, BeginsAndEndsAtRestExactlyWhereTheProgramSays) {
  for (const ProfileKind kind :
       {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
        ProfileKind::sine_series, ProfileKind::sigmoid}) {
    SCOPED_TRACE(profiles::name_of(kind));
    Kernel kernel(mill(), {.profile = Profile{kind}});
    kernel.feed("G21 G90 G1 X1.234567 Y-2.345678 Z0.1 F3000\nG2 X3.3 Y-2.345678 I1.0327165\nM2\n");
    kernel.finish();
    const auto ticks = rest_of(kernel);
    EXPECT_EQ(ticks.front().position_mm, (curves::Position{0, 0, 0}));
    EXPECT_EQ(ticks.back().position_mm, (curves::Position{3.3, -2.345678, 0.1}));
    EXPECT_EQ(ticks.back().v_mm_s, 0.0);
    EXPECT_EQ(ticks.back().a_mm_s2, 0.0);
    EXPECT_EQ(kernel.totals().ticks, ticks.back().tick);
    Setpoint again;
    EXPECT_EQ(kernel.next(again), TickStatus::finished);
    EXPECT_EQ(again.position_mm, ticks.back().position_mm);
  }
}

TEST(Kernel, KeepsEveryLimitAtEveryTick) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
                                 ProfileKind::sine_series, ProfileKind::sigmoid}) {
    SCOPED_TRACE(profiles::name_of(kind));
    TickChecker checker(mill().limits, true);
    for (const Setpoint& tick : ticks_of(mixed_program(), {.profile = Profile{kind}})) {
      checker.add({.setpoint = tick, .feedrate_mm_s = 150.0});
    }
    EXPECT_EQ(checker.complaint(), "");
  }
}

TEST(Kernel, DwellsForAWholeNumberOfTicks) {
  const auto ticks = ticks_of("G21 G90 G1 X1 F600\nG4 P0.2503\nG1 X2\nM2\n");
  std::int64_t resting = 0;
  for (const Setpoint& tick : ticks) {
    resting += tick.position_mm[0] == 1.0 ? 1 : 0;
  }
  // 251 periods hold the dwell; it begins and ends with a tick, both at rest.
  EXPECT_GE(resting, 252);
  EXPECT_LE(resting, 253);
}

TEST(Kernel, StopsAtRestBeforeABlockThatIsWrong) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X10 F3000\nX20\nX30 Q1 @\nX40\nM2\n");
  kernel.finish();
  const auto ticks = rest_of(kernel);
  EXPECT_TRUE(kernel.has_errors());
  ASSERT_FALSE(kernel.diagnostics().empty());
  EXPECT_EQ(kernel.diagnostics().front().source.line, 3U);
  EXPECT_EQ(ticks.back().position_mm, (curves::Position{20, 0, 0}));
  TickChecker checker(mill().limits, true);
  for (const Setpoint& tick : ticks) {
    checker.add({.setpoint = tick, .feedrate_mm_s = 50.0});
  }
  EXPECT_EQ(checker.complaint(), "");
}

// Neither the corner into it is rounded nor the lines before it are lost in one that leaves.
TEST(Kernel, StopsAtRestBeforeABlockThatLeavesTheTravel) {
  struct Case {
    std::string_view text;
    std::uint32_t line;
    curves::Position end_mm;
  };
  for (const Case& of : {
           Case{"G1 X490 F6000\nY20\nX520\nX480\n", 3, {490, 20, 0}},
           Case{"G64 P5 G1 X490 F6000\nY20\nX520\nX480\n", 3, {490, 20, 0}},
           Case{"G64 P5 G1 X490 F6000\nY20\nG2 X490 Y-20 R20\n", 3, {490, 20, 0}},
           Case{"G64 G1 X499.6 F6000\nX499.7\nX499.8\nX499.9\nX500.1\nX500.2\nX480\n",
                5,
                {499.9, 0, 0}},
       }) {
    SCOPED_TRACE(of.text);
    Kernel kernel(default_machine(), {.checks_travel = true});  // of x from -500 to 500
    kernel.feed(of.text);
    kernel.finish();
    EXPECT_EQ(rest_of(kernel).back().position_mm, of.end_mm);
    EXPECT_TRUE(kernel.left_travel());
    ASSERT_EQ(kernel.diagnostics().size(), 1U);
    EXPECT_EQ(kernel.diagnostics().front().source.line, of.line);
  }
}

TEST(Kernel, StopsAtRestBeforeACurveThatCannotBeBuilt) {
  Kernel kernel(mill());
  kernel.feed(
      "G21 G90 G1 X10 F3000\nG6.2 P3 K0 X10 Y0 F1000\nK0 X2000000000 Y0\nK0 X10 Y0\nK1\nK1\nK1\nG1 "
      "X40\n"
      "M2\n");
  kernel.finish();
  const auto ticks = rest_of(kernel);  // a point beyond 1e9 mm
  EXPECT_TRUE(kernel.has_errors());
  ASSERT_FALSE(kernel.diagnostics().empty());
  EXPECT_GE(kernel.diagnostics().back().source.line, 2U);
  EXPECT_LE(kernel.diagnostics().back().source.line, 7U);
  EXPECT_EQ(ticks.back().position_mm, (curves::Position{10, 0, 0}));
}

// A tenth of a second at the feedrate, so the way down begins on a tick, as exactly as numbers
// tell.
TEST(Kernel, RunsToItsEndWhereAChangeOfTheMotionFallsOnATick) {
  for (const auto kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const auto ticks = ticks_of(
        "G61.1 G93 G1 X0.5 Y0.2995 F120\n"
        "X1 Y0.596 F600\n"
        "M2\n",
        {.profile = Profile{kind}});
    EXPECT_EQ(ticks.back().position_mm, (curves::Position{1, 0.596, 0}));
  }
}

TEST(Kernel, StarvesAtRestBeforeTheFirstText) {
  Kernel kernel(mill(), {.start_mm = {1, 2, 3}});
  Setpoint setpoint;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(kernel.next(setpoint), TickStatus::starved);
    EXPECT_EQ(setpoint.position_mm, (curves::Position{1, 2, 3}));
    EXPECT_EQ(setpoint.tick, i);
  }
  kernel.feed("G21 G90 G1 X5 Y2 Z3 F1000\nM2\n");
  kernel.finish();
  TickChecker checker(mill().limits, true);
  checker.add({.setpoint = setpoint, .feedrate_mm_s = 1000.0 / 60.0});
  for (const Setpoint& tick : rest_of(kernel)) {
    checker.add({.setpoint = tick, .feedrate_mm_s = 1000.0 / 60.0});
  }
  EXPECT_EQ(checker.complaint(), "");
}

TEST(Kernel, TakesAQueueThatRunsDryForNoFaultOfThePlan) {
  Kernel kernel(mill());
  kernel.feed("G1 F6000 X100\nX0\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  // Planned late, twice: the tool stands still in motion and goes on as fast as it was.
  for (int turn = 0; turn < 2; ++turn) {
    kernel.plan();
    auto status = TickStatus::running;
    while (status == TickStatus::running) {
      status = kernel.tick(setpoint);
    }
    ASSERT_EQ(status, TickStatus::starved);
    kernel.tick(setpoint);
  }
  EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
  rest_of(kernel);
}

// More than the queue holds.
TEST(Kernel, PassesThousandsOfBlocksInATickWithoutStandingStill) {
  Kernel kernel(mill());
  kernel.feed("G91 G1 F6000\no1 repeat [5000]\nX[2/10**9]\no1 endrepeat\nX1\nM2\n");
  kernel.finish();
  EXPECT_NEAR(rest_of(kernel).back().position_mm[0], 1.00001, 1e-12);
  EXPECT_EQ(kernel.totals().blocks, 5001U);
}

}  // namespace
}  // namespace kerf::test
