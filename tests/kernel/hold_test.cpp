// A feed hold at any tick of a program of every kind of motion, and what comes after it.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

// A hold before that tick may find the program at its end.
bool ends_first(std::int64_t tick, const WholeRun& whole) {
  return whole.back().tick - tick <= kLongestStop_ticks;
}

TEST(Hold, ComesToRestOnThePathAndGoesOnToTheSameEndWhereverItIsAskedFor) {
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::quintic,
                                 ProfileKind::time_optimal}) {
    const WatchedProgram program{.text = mixed_program(), .options = {.profile = {.kind = kind}}};
    const auto whole = ticks_of(program.text, program.options);
    for (std::int64_t tick = 1; tick < whole.back().tick; tick += 41) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick) + " of " +
                   std::to_string(whole.back().tick));
      const WatchedRun run = run_held(program, {tick});
      expect_whole(run, whole);
      EXPECT_TRUE(run.count(TickStatus::held) == kHeldTicks || ends_first(tick, whole));
      ASSERT_FALSE(testing::Test::HasFailure());
    }
  }
}

TEST(Hold, MayComeWhileTheToolBrakesAndAgainBehindIt) {
  const WatchedProgram program{.text = mixed_program()};
  const auto whole = ticks_of(program.text, program.options);
  for (std::int64_t tick = 1; tick + 400 < whole.back().tick; tick += 203) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    const WatchedRun run = run_held(program, {tick, tick + 15, tick + 30, tick + 160, tick + 300});
    expect_whole(run, whole);
    EXPECT_GE(run.count(TickStatus::held), 2 * kHeldTicks);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

// From there on it is another program's: from that place, by the same profile.
TEST(Hold, GoesOnWithTheChosenProfileBehindItsRest) {
  for (const ProfileKind kind : {ProfileKind::sine, ProfileKind::quintic, ProfileKind::sigmoid,
                                 ProfileKind::sine_series, ProfileKind::s_curve}) {
    SCOPED_TRACE(name_of(kind));
    const KernelOptions options{.profile = {.kind = kind}};
    const WatchedRun run =
        run_held({.text = "G21 G90 G61\nG1 X200 F6000\nM2\n", .options = options}, {1000});
    EXPECT_EQ(run.complaint, "");
    KernelOptions there = options;
    there.start_mm = run.first_held().position_mm;
    const WholeRun rest = ticks_of("G21 G90 G61\nG1 X200 F6000\nM2\n", there);
    const auto moves = [](const Setpoint& tick) { return tick.v_mm_s > 0.0; };
    const auto begin = std::find_if(run.ticks.end() - std::ssize(rest), run.ticks.end(), moves);
    const auto rest_begin = std::ranges::find_if(rest, moves);
    ASSERT_EQ(run.ticks.end() - begin, rest.end() - rest_begin);
    for (std::ptrdiff_t i = 0; i < rest.end() - rest_begin; ++i) {
      ASSERT_NEAR(begin[i].v_mm_s, rest_begin[i].v_mm_s, 1e-6) << i;
    }
  }
}

// A plan that reaches as far as it may fills the queue; there is room for a hold and an override.
TEST(Hold, IsHeededHoweverFarIsPlanned) {
  std::string text = "G21 G90 G61 F600\n";
  for (int i = 0; i < 200; ++i) {
    text += "G1 X200\nG1 X0\n";  // 20 s each
  }
  for (const bool holds : {true, false}) {
    Kernel kernel(default_machine(), {.horizon_s = 3600.0, .one_thread = true});
    kernel.feed(text);
    kernel.finish();
    Setpoint setpoint;
    for (int i = 0; i < 5000; ++i) {
      ASSERT_EQ(kernel.next(setpoint), TickStatus::running);
    }
    if (holds) {
      kernel.hold();
    } else {
      ASSERT_TRUE(kernel.set_overrides({.feed = 0.5}));
    }
    TickStatus status = TickStatus::running;
    double before_mm = 0.0;
    for (int i = 0; i < 500; ++i) {
      before_mm = setpoint.position_mm[0];
      status = kernel.next(setpoint);
    }
    EXPECT_EQ(status, holds ? TickStatus::held : TickStatus::running);
    EXPECT_NEAR(setpoint.position_mm[0] - before_mm, holds ? 0.0 : 0.005, 1e-5);
  }
}

TEST(Hold, OfTheSameTickGivesTheSameTicks) {
  const WatchedProgram program{.text = mixed_program()};
  const WatchedRun one = run_held(program, {500});
  const WatchedRun two = run_held(program, {500});
  ASSERT_EQ(one.ticks.size(), two.ticks.size());
  for (std::size_t i = 0; i < one.ticks.size(); ++i) {
    ASSERT_EQ(one.ticks[i].position_mm, two.ticks[i].position_mm) << i;
  }
}

TEST(Hold, StopsTheClockOfADwell) {
  const WatchedProgram program{.text = "G21 G90 F6000\nG1 X10\nG4 P0.5\nX20\nM2\n"};
  const auto whole = ticks_of(program.text, program.options);
  const auto dwells = std::find_if(
      whole.begin(), whole.end(), [](const Setpoint& tick) { return tick.position_mm[0] == 10.0; });
  const WatchedRun run = run_held(program, {dwells->tick + 100});
  EXPECT_EQ(run.complaint, "");
  EXPECT_EQ(run.first_held().position_mm[0], 10.0);
  EXPECT_EQ(run.first_held().line, 3U);
  EXPECT_EQ(run.count(TickStatus::held), kHeldTicks);
  EXPECT_EQ(run.count(TickStatus::running) + 1, static_cast<std::int64_t>(whole.size()));
}

TEST(Hold, LeavesOutputsAtTheirPlaces) {
  const WatchedProgram program{
      .text =
          "G21 G90 F3000\nG1 X10\nM62 P1\nX20\nM63 P1\nM62 P2\nX30\nM3 S100\n"
          "X40\nM5\nM2\n",
      .options = {.profile = {.kind = ProfileKind::s_curve}}};
  const auto switched = [](const std::vector<Setpoint>& ticks) {
    std::vector<std::pair<std::uint64_t, double>> changes;
    for (std::size_t i = 1; i < ticks.size(); ++i) {
      if (ticks[i].outputs != ticks[i - 1].outputs) {
        // The block that it is on: a tick may be anywhere after the block's begin.
        changes.emplace_back(ticks[i].outputs.digital, std::floor(ticks[i].s_mm / 10.0));
      }
    }
    return changes;
  };
  const auto whole = ticks_of(program.text, program.options);
  ASSERT_EQ(switched(whole).size(), 4U);
  for (std::int64_t tick = 1; tick < whole.back().tick; tick += 29) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    const WatchedRun run = run_held(program, {tick});
    EXPECT_EQ(run.complaint, "");
    EXPECT_TRUE(run.count(TickStatus::held) == kHeldTicks || ends_first(tick, whole));
    EXPECT_EQ(switched(run.ticks), switched(whole));
  }
}

TEST(Hold, WaitsWhereTheTextIsLate) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X10 F3000\n");
  Setpoint setpoint;
  while (kernel.next(setpoint) != TickStatus::starved) {
  }
  kernel.hold();
  TickStatus status = TickStatus::starved;
  for (int i = 0; i < 50; ++i) {
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, TickStatus::held);
  kernel.feed("X20\nM2\n");
  kernel.finish();
  EXPECT_EQ(kernel.next(setpoint), TickStatus::held);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  kernel.resume();
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
}

TEST(Hold, MayComeBeforeTheFirstText) {
  Kernel kernel(mill());
  Setpoint setpoint;
  kernel.next(setpoint);
  kernel.hold();
  kernel.next(setpoint);
  EXPECT_EQ(kernel.next(setpoint), TickStatus::held);
  kernel.feed("G21 G90 G1 X20 F3000\nM2\n");
  kernel.finish();
  kernel.resume();
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
}

// With plan() and tick() apart a way to rest is kept ready, and a hold takes its place.
TEST(Hold, GoesOnToTheSameEndWherePlanningHasAThreadOfItsOwn) {
  const auto whole = ticks_of(mixed_program());
  for (std::int64_t tick = 1; tick < whole.back().tick; tick += 97) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    Kernel kernel(mill());
    kernel.feed(mixed_program());
    kernel.finish();
    TickChecker checker(mill().limits, true);
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    int held = 0;
    for (std::int64_t i = 0; i < kMaxTicks && status != TickStatus::finished; ++i) {
      kernel.plan();
      if (i == tick) {
        kernel.hold();
      }
      status = kernel.tick(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
      held += status == TickStatus::held ? 1 : 0;
      if (held == kHeldTicks && status == TickStatus::held) {
        kernel.resume();
      }
    }
    EXPECT_EQ(status, TickStatus::finished);
    EXPECT_TRUE(held == kHeldTicks || ends_first(tick, whole));
    EXPECT_EQ(checker.complaint(), "");
    EXPECT_EQ(setpoint.position_mm, whole.back().position_mm);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(Hold, DoesNothingOnceTheProgramHasEnded) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1 F6000\nM2\n");
  kernel.finish();
  Setpoint setpoint = rest_of(kernel).back();
  kernel.hold();
  EXPECT_EQ(kernel.next(setpoint), TickStatus::finished);
}

TEST(Hold, EndsWithTheProgramWhereItIsStopped) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G1 X1000 F6000\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 1000; ++i) {
    kernel.next(setpoint);
  }
  kernel.hold();
  while (kernel.next(setpoint) != TickStatus::held) {
  }
  const double at_mm = setpoint.position_mm[0];
  kernel.stop();
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], at_mm);
}

}  // namespace
}  // namespace kerf::test
