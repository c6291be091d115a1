// Feed and rapid override at any tick of a program of every kind of motion.
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

constexpr double kFastest_mm_s = 150.0;  // of the mill

using OverridesAt = std::map<std::int64_t, Overrides>;  // before each of these ticks

struct OverriddenRun {
  std::vector<Setpoint> ticks;
  std::string complaint;
};

OverriddenRun run_with(const std::string& text, const KernelOptions& options,
                       const OverridesAt& overrides) {
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  TickChecker checker(mill().limits, options.profile.kind != ProfileKind::trapezoid);
  OverriddenRun run;
  TickStatus status = TickStatus::running;
  while (status != TickStatus::finished && status != TickStatus::failed &&
         run.ticks.size() < kMaxTicks) {
    if (const auto now = overrides.find(static_cast<std::int64_t>(run.ticks.size()));
        now != overrides.end()) {
      EXPECT_TRUE(kernel.set_overrides(now->second));
    }
    Setpoint setpoint;
    status = kernel.next(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
    run.ticks.push_back(setpoint);
  }
  run.complaint = complaint_at_end(status, checker, kernel);
  return run;
}

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

TEST(Override, LeavesTheHoldOfAnOperatorAndAWait) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90\nG1 X10 F3000\nM0\nX20\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  const auto run_for = [&](int ticks) {
    TickStatus status = TickStatus::running;
    for (int i = 0; i < ticks; ++i) {
      status = kernel.next(setpoint);
    }
    return status;
  };
  run_for(100);
  kernel.hold();
  EXPECT_EQ(run_for(200), TickStatus::held);
  EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
  EXPECT_EQ(run_for(20), TickStatus::held);
  EXPECT_TRUE(kernel.set_overrides({.feed = 0.5}));
  EXPECT_EQ(run_for(20), TickStatus::held);
  kernel.resume();
  EXPECT_EQ(run_for(2000), TickStatus::waiting);
  EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
  EXPECT_EQ(run_for(20), TickStatus::waiting);
  EXPECT_TRUE(kernel.set_overrides({.feed = 0.25}));
  EXPECT_EQ(run_for(20), TickStatus::waiting);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  kernel.resume();
  EXPECT_EQ(run_for(300), TickStatus::running);
  EXPECT_NEAR(setpoint.v_mm_s, 12.5, 1e-6);
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
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
      ASSERT_LE(off_path_mm(whole, setpoint), 1e-9);
    }
    ASSERT_EQ(checker.complaint(), "");
    ASSERT_EQ(setpoint.position_mm, whole.back().position_mm);
  }
}

double fastest_on_line_mm_s(const std::vector<Setpoint>& ticks, std::uint32_t line) {
  double most = 0.0;
  for (const Setpoint& tick : ticks) {
    most = tick.line == line ? std::max(most, tick.v_mm_s) : most;
  }
  return most;
}

TEST(Override, IsNotFollowedWhereTheProgramForbidsIt) {
  const std::string text =
      "G21 G90 G61 F3000\nG1 X40\nM49 X80\nM48 X120\nM50 P0 X160\nM50 P1 X200\nM2\n";
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const auto run =
        run_with(text, {.profile = {.kind = kind}}, {{0, {.feed = 0.5}}, {3000, {.feed = 1.2}}});
    EXPECT_EQ(run.complaint, "");
    EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 2), 25.0, 0.02);
    EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 3), 50.0, 0.02);
    EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 4), 60.0, 0.02);
    EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 5), 50.0, 0.02);
    EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 6), 60.0, 0.02);
  }
}

// 600 revolutions a minute of 2 mm are 20 mm/s.
TEST(Override, OfTheSpindleChangesItsSpeedAndFeedratesPerRevolution) {
  const std::string text =
      "G21 G90 G61 M3 S600\nG95 F2 G1 X40\nG94 F1200 X80\nM51 P0 G95 F2 X120\nM5\nM2\n";
  const double rad_s = 600.0 / 60.0 * 2.0 * 3.14159265358979323846;
  const auto run = run_with(text, {}, {{0, {.spindle = 1.5}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 2), 30.0, 0.02);
  EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 3), 20.0, 0.02);
  EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 4), 20.0, 0.02);
  for (const Setpoint& tick : run.ticks) {
    if (tick.line >= 2 && tick.line <= 4 && tick.v_mm_s > 0.0) {
      ASSERT_NEAR(tick.outputs.spindle_rad_s, tick.line == 4 ? rad_s : 1.5 * rad_s, 1e-9)
          << tick.tick;
    }
  }
}

TEST(Override, OfTheSpindleIsNotFollowedWhileTapping) {
  const std::string text = "G21 G90 F600 M3 S600\nG0 X5\nG84 X10 Z-10 R2\nG80\nG1 X20\nM2\n";
  const auto plain = run_with(text, {}, {});
  const auto run = run_with(text, {}, {{0, {.feed = 0.5, .spindle = 0.5}}});
  EXPECT_EQ(run.complaint, "");
  EXPECT_NEAR(fastest_on_line_mm_s(run.ticks, 5), 5.0, 0.02);
  const double rad_s = 600.0 / 60.0 * 2.0 * 3.14159265358979323846;
  double slowest = rad_s;
  double fastest_down_mm_s = 0.0;
  for (const Setpoint& tick : run.ticks) {
    if (tick.line == 3 && tick.velocity_mm_s[2] != 0.0 && !tick.rapid) {
      slowest = std::min(slowest, std::abs(tick.outputs.spindle_rad_s));
      fastest_down_mm_s = std::max(fastest_down_mm_s, std::abs(tick.velocity_mm_s[2]));
    }
  }
  EXPECT_NEAR(slowest, rad_s, 1e-9);
  EXPECT_NEAR(fastest_down_mm_s, 10.0, 0.02);
}

TEST(Override, OutOfItsRangeIsRefused) {
  Kernel kernel(mill());
  for (const Overrides& impossible :
       {Overrides{.feed = -0.1}, Overrides{.feed = 2.1}, Overrides{.feed = std::nan("")},
        Overrides{.rapid = 0.04}, Overrides{.rapid = 1.01}, Overrides{.spindle = 0.05},
        Overrides{.spindle = 2.5}}) {
    EXPECT_FALSE(kernel.set_overrides(impossible));
  }
  EXPECT_TRUE(kernel.set_overrides({.feed = 2.0, .rapid = 0.05}));
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

TEST(Override, MayChangeEveryTenMilliseconds) {
  const auto whole = ticks_of(mixed_program());
  for (std::uint32_t seed = 1; seed <= 2; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> feed(0.0, 2.0);
    OverridesAt overrides;
    for (std::int64_t tick = 0; tick < 6000; tick += 10) {
      overrides[tick] = {.feed = feed(random)};
    }
    expect_whole(run_with(mixed_program(), {}, overrides), whole);
  }
}

}  // namespace
}  // namespace kerf::test
