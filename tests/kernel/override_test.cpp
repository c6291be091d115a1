// Feed and rapid override at any tick of a program of every kind of motion.
#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/overridden_run.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

double slowest_mm_s(const std::vector<Setpoint>& ticks, std::size_t begin, std::size_t end) {
  double least = kFastest_mm_s;
  for (std::size_t i = begin; i < end; ++i) {
    least = std::min(least, ticks.at(i).v_mm_s);
  }
  return least;
}

double fastest_mm_s(const std::vector<Setpoint>& ticks, std::size_t begin, std::size_t end) {
  double most = 0.0;
  for (std::size_t i = begin; i < end; ++i) {
    most = std::max(most, ticks.at(i).v_mm_s);
  }
  return most;
}

// All of it at this feedrate, but for rapids.
std::string mixed_program_at(const std::string& feedrate) {
  return std::regex_replace(mixed_program(), std::regex("F[0-9]+"), "F" + feedrate);
}

TEST(Override, LeavesPathAndLimitsWhereverItIsAskedFor) {
  for (const ProfileKind kind : {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::quintic,
                                 ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(mixed_program(), options);
    for (std::int64_t tick = 1; tick < whole.back().tick; tick += 83) {
      for (const double feed : {0.4, 1.7}) {
        SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick) + ", " +
                     std::to_string(feed));
        expect_whole(run_with(mixed_program(), options, {{tick, {.feed = feed}}}), whole);
        ASSERT_FALSE(testing::Test::HasFailure());
      }
    }
  }
}

// A corner here is a curve that is passed within a tick: its feedrate is that of
// the tick, which the share of rapids does not change as it changes that of the way before it.
TEST(Override, OfRapidsHoldsWhereAWholeCurveIsPassedWithinATick) {
  MachineSettings settings = default_machine();
  settings.program.path_control = {};
  const std::string text =
      "G21 G64 P0.05 G90 G94 F600\nG0 X13.913185 Y10 Z10.009746\n"
      "G1 Y-15.365518 F1328.648355\nG0 Z10\nG0 X1 Y2\nM2\n";
  for (const double rapid : {0.1, 0.35, 0.8}) {
    for (const std::int64_t tick : {0, 300, 700, 1100}) {
      SCOPED_TRACE(std::to_string(rapid) + ", tick " + std::to_string(tick));
      EXPECT_EQ(run_with(text, {}, {{tick, {.rapid = rapid}}}, settings).complaint, "");
    }
  }
}

// The feedrates are those that the program would have with other F words.
TEST(Override, FromTheBeginGivesTheTicksOfAProgramOfThatFeedrate) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    for (const auto& [share, feedrate] : {std::pair{0.5, "1500"}, {1.0, "3000"}, {1.5, "4500"}}) {
      const auto expected = ticks_of(mixed_program_at(feedrate), options);
      const auto run = run_with(mixed_program_at("3000"), options, {{0, {.feed = share}}});
      EXPECT_EQ(run.complaint, "");
      ASSERT_EQ(run.ticks.size(), expected.size());
      for (std::size_t i = 0; i < expected.size(); ++i) {
        ASSERT_EQ(run.ticks[i].position_mm, expected[i].position_mm) << i;
      }
    }
  }
}

// Nothing of the plan may grow with the time that a feedrate next to 0 takes.
TEST(Override, OfNextToNothingIsPlannedAsSoonAsAnyOther) {
  const std::string text = "G21 G90\nG1 X400 F6000\nG0 X10\nM2\n";
  for (const double feed : {1e-4, 1e-6, 1e-9, 1e-300}) {
    SCOPED_TRACE(feed);
    const auto run = run_with(text, {}, {{500, {.feed = feed}}, {900, {.feed = 1.0}}});
    EXPECT_EQ(run.complaint, "");
  }
  const std::string circle = "G21 G90 G61\nG1 X0 F3000\nG2 X0 I30\nM2\n";
  using At = std::pair<std::string, std::int64_t>;
  for (const auto& [curves, tick] : {At{circle, 476}, At{shipped_program("star.ngc"), 1456}}) {
    const auto run = run_with(curves, {}, {{tick, {.feed = 1e-6}}, {tick + 300, {.feed = 1.0}}});
    EXPECT_EQ(run.complaint, "") << tick;
  }
  const auto whole = ticks_of(mixed_program(), {});
  for (std::int64_t tick = 1; tick < whole.back().tick; tick += 811) {
    SCOPED_TRACE(tick);
    const OverridesAt overrides{{tick, {.feed = 1e-5}}, {tick + 300, {.feed = 1.0}}};
    expect_whole(run_with(mixed_program(), {}, overrides), whole);
  }
}

// From 100 to 50 mm/s under A = 2000 and J = 50,000 takes dv/A + A/J = 65 ms; the other way the
// same.
TEST(Override, OnALineTakesTheTimeOfAnSCurveAndDoesNotDiveBelow) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto run = run_with("G21 G90\nG1 X1000 F6000\nM2\n", options,
                              {{1000, {.feed = 0.5}}, {2000, {.feed = 1.0}}});
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.ticks.at(1009).v_mm_s, run.ticks.at(999).v_mm_s);
    EXPECT_LT(run.ticks.at(1015).v_mm_s, 99.99);
    EXPECT_GT(slowest_mm_s(run.ticks, 1000, 2000), 49.9);
    EXPECT_LT(fastest_mm_s(run.ticks, 1010 + 75, 2000), 50.1);
    EXPECT_GT(slowest_mm_s(run.ticks, 2010 + 75, 3000), 99.5);
    EXPECT_LE(fastest_mm_s(run.ticks, 2000, 3000), 100.0 * (1.0 + 1e-9));
  }
}

TEST(Override, IsKeptOnBlocksOfAllKindsOnceTheToolHasSlowedDown) {
  const std::string program = mixed_program_at("4800");
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(program, options);
    for (std::int64_t tick = 1; tick < whole.back().tick; tick += 167) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick));
      const auto run = run_with(program, options, {{tick, {.feed = 0.25, .rapid = 0.2}}});
      const auto slow = std::min(static_cast<std::size_t>(tick) + 150, run.ticks.size());
      EXPECT_LE(fastest_mm_s(run.ticks, slow, run.ticks.size()), 30.0 * (1.0 + 1e-6));
      for (std::size_t i = slow; i < run.ticks.size(); ++i) {
        if (!run.ticks[i].rapid) {
          ASSERT_LE(run.ticks[i].v_mm_s, 20.0 * (1.0 + 1e-6)) << i;
        }
      }
    }
  }
}

TEST(Override, OfRapidsLeavesProgrammedFeedrates) {
  const std::string text = "G21 G90\nG0 X200\nG1 X250 F1200\nG0 X0\nM2\n";
  const auto whole = ticks_of(text);
  const auto run = run_with(text, {}, {{200, {.rapid = 0.1}}});
  EXPECT_EQ(run.complaint, "");
  for (std::size_t i = 400; i < run.ticks.size(); ++i) {
    ASSERT_LE(run.ticks[i].v_mm_s, (run.ticks[i].rapid ? 15.0 : 20.0) * (1.0 + 1e-9)) << i;
  }
  const auto feeds = std::count_if(run.ticks.begin(), run.ticks.end(), [](const Setpoint& tick) {
    return std::abs(tick.v_mm_s - 20.0) < 0.02;
  });
  EXPECT_GT(feeds, 2000);
}

TEST(Override, AboveOneHundredPercentIsFasterWithinTheLimits) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(mixed_program_at("1200"), options);
    const auto run = run_with(mixed_program_at("1200"), options, {{700, {.feed = 2.0}}});
    expect_whole(run, whole);
    EXPECT_LT(static_cast<double>(run.ticks.size()), 0.75 * static_cast<double>(whole.size()));
  }
}

TEST(Override, OfZeroHoldsUntilAnotherComes) {
  const std::string text = "G21 G90\nG1 X100 F3000\nM2\n";
  const auto run =
      run_with(text, {}, {{500, {.feed = 0.0}}, {1000, {.feed = 0.0}}, {1500, {.feed = 0.8}}});
  expect_whole(run, ticks_of(text));
  EXPECT_EQ(run.ticks.at(700).position_mm, run.ticks.at(1499).position_mm);
  EXPECT_EQ(fastest_mm_s(run.ticks, 700, 1500), 0.0);
  EXPECT_NEAR(fastest_mm_s(run.ticks, 1500, run.ticks.size()), 40.0, 1e-6);
}

// While the plan of the first is on its way to the ticks, and before one is made.
TEST(Override, IsTheLastOneWhereSomeComeAtOnce) {
  const std::string text = "G21 G90\nG1 X200 F3000\nM2\n";
  for (const std::int64_t apart : {0, 1, 3, 8}) {
    for (const double last : {0.4, 1.6}) {
      SCOPED_TRACE(std::to_string(apart) + " ticks, " + std::to_string(last));
      const WatchedRun run =
          watched_run({.text = text}, [&](Kernel& kernel, const WatchedRun& ran) {
            if (ran.next() == 500) {
              EXPECT_TRUE(kernel.set_overrides({.feed = 2.0 - last}));
            }
            if (ran.next() == 500 + apart) {
              EXPECT_TRUE(kernel.set_overrides({.feed = last}));
            }
          });
      expect_whole(run, ticks_of(text));
      EXPECT_NEAR(run.ticks.at(800).v_mm_s, 50.0 * last, 0.05);
    }
  }
}

// The rest of the hold was planned, and is not come to.
TEST(Override, MayComeWhileTheToolBrakesForAHoldThatIsTakenBack) {
  const auto whole = ticks_of(mixed_program());
  for (std::int64_t tick = 50; tick + 300 < whole.back().tick; tick += 199) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    Kernel kernel(mill());
    kernel.feed(mixed_program());
    kernel.finish();
    TickChecker checker(mill().limits, true);
    TickStatus status = TickStatus::running;
    Setpoint setpoint;
    for (std::int64_t i = 0; status != TickStatus::finished && i < kMaxTicks; ++i) {
      if (i == tick) {
        kernel.hold();
      } else if (i == tick + 20) {
        kernel.resume();
        kernel.set_overrides({.feed = 1.5});
      } else if (i == tick + 45) {
        kernel.set_overrides({.feed = 0.6});
      }
      status = kernel.next(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
      ASSERT_LE(whole.off_path_mm(setpoint), 1e-9);
    }
    ASSERT_EQ(checker.complaint(), "");
    ASSERT_EQ(setpoint.position_mm, whole.back().position_mm);
  }
}

TEST(Override, OfTheSameTicksGivesTheSameTicks) {
  const OverridesAt overrides{{300, {.feed = 0.3}}, {420, {.feed = 1.4}}, {500, {.feed = 0.9}}};
  const auto one = run_with(mixed_program(), {}, overrides);
  const auto two = run_with(mixed_program(), {}, overrides);
  ASSERT_EQ(one.ticks.size(), two.ticks.size());
  for (std::size_t i = 0; i < one.ticks.size(); ++i) {
    ASSERT_EQ(one.ticks[i].position_mm, two.ticks[i].position_mm) << i;
  }
}

class ManyOverrides : public testing::TestWithParam<std::uint32_t> {};

TEST_P(ManyOverrides, MayComeEveryTenMilliseconds) {
  std::mt19937 random(GetParam());
  std::uniform_real_distribution<double> feed(0.0, 2.0);
  OverridesAt overrides;
  for (std::int64_t tick = 0; tick < 6000; tick += 10) {
    overrides[tick] = {.feed = feed(random)};
  }
  expect_whole(run_with(mixed_program(), {}, overrides), ticks_of(mixed_program()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ManyOverrides, testing::Values(1U, 2U));

}  // namespace
}  // namespace kerf::test
