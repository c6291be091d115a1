// What an override counts for: feedrates and the spindle, where the program allows it.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/overridden_run.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

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

// Where it is on.
TEST(Override, Of0HoldsNothingWhereTheProgramForbidsIt) {
  for (const std::string off : {"M49", "M50 P0"}) {
    const auto run = watched_run({.text = "G21 G90 G61 F3000\n" + off + "\nG1 X20\nM48\nX40\nM2\n"},
                                 [&](Kernel& kernel, const WatchedRun& watched) {
                                   if (watched.next() == 100) {
                                     EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
                                   } else if (watched.next() == 1500) {
                                     EXPECT_TRUE(kernel.set_overrides({.feed = 1.0}));
                                   }
                                 });
    EXPECT_EQ(run.complaint, "");
    const Setpoint& held = run.first_held();
    EXPECT_EQ(held.line, 5U);
    EXPECT_GT(held.position_mm[0], 20.0);
    EXPECT_LT(held.position_mm[0], 25.0);
    EXPECT_GT(run.count(TickStatus::held), 500);
  }
}

// Found with a client: after M49 the spindle started at its override, and came to the programmed
// speed with the next motion alone.
TEST(Override, OfTheSpindleCountsAtRestsAsTheProgramHasItThere) {
  constexpr double kProgrammed = 2.0 * 3.14159265358979323846 * 1000.0 / 60.0;
  MachineSettings settings = mill();
  settings.program.spindle_start_s = 0.2;
  Kernel kernel(settings, {.waits = true});
  kernel.feed(
      "G21 G90\nM49\nM62 P1\nM3 S1000\nG4 P0.1\nM48\nM0\nM49\nM53 P0\nM0\nG1 X1 F600\nM2\n");
  kernel.finish();
  ASSERT_TRUE(kernel.set_overrides({.spindle = 0.5}));
  Setpoint setpoint;
  std::vector<double> shares;  // each of the programmed speed, one after the other
  int waits = 0;
  for (auto status = TickStatus::running;
       status != TickStatus::finished && status != TickStatus::failed;) {
    status = kernel.next(setpoint);
    const double share = setpoint.outputs.spindle_rad_s / kProgrammed;
    if (share > 0.0 && (shares.empty() || std::abs(share - shares.back()) > 1e-9)) {
      shares.push_back(share);
    }
    if (status == TickStatus::waiting) {
      ++waits;
      EXPECT_NEAR(share, waits == 1 ? 0.5 : 1.0, 1e-9);
      EXPECT_EQ(setpoint.outputs.heeds_feed_stop, waits == 1);
      EXPECT_EQ(setpoint.outputs.digital, 0U) << "M62 comes with a motion";
      kernel.resume();
    }
    if (setpoint.v_mm_s > 0.0) {
      EXPECT_EQ(setpoint.outputs.digital, 2U);
    }
  }
  EXPECT_EQ(waits, 2);
  ASSERT_EQ(shares.size(), 3U);
  EXPECT_NEAR(shares[0], 1.0, 1e-9);
  EXPECT_NEAR(shares[1], 0.5, 1e-9);
  EXPECT_NEAR(shares[2], 1.0, 1e-9);
}

// A tap that stops while its spindle turns breaks. What is asked for within it counts after it.
TEST(Tap, IsStoppedByNothingButAnEmergencyStop) {
  const std::string text =
      "G21 G90 G0 Z5\nS600 M3\nG98 G84 X0 Y0 Z-10 R2 F600\nG80\nG1 X50 F3000\nM5\nM2\n";
  const KernelOptions options{.start_mm = {0.0, 0.0, 5.0}};
  const auto undisturbed =
      watched_run({.text = text, .options = options}, [](Kernel&, const WatchedRun&) {});
  const auto in_hole = [](const Setpoint& tick) { return tick.position_mm[2] < 2.0; };
  const auto of_tap = [&](const WatchedRun& run) {
    std::vector<std::array<double, 2>> place_and_spindle;
    for (const Setpoint& tick : run.ticks) {
      if (in_hole(tick)) {
        place_and_spindle.push_back({tick.position_mm[2], tick.outputs.spindle_rad_s});
      }
    }
    return place_and_spindle;
  };
  const auto of_tap_undisturbed = of_tap(undisturbed);
  const auto first = std::ranges::find_if(undisturbed.ticks, in_hole);
  const auto begin = first - undisturbed.ticks.begin();
  ASSERT_GT(of_tap_undisturbed.size(), 1000U);
  for (std::int64_t tick = begin + 5; tick < begin + 2400; tick += 300) {
    for (const std::string what : {"hold", "feed 0", "feed stop"}) {
      SCOPED_TRACE(what + " at " + std::to_string(tick));
      const auto run = watched_run({.text = text, .options = options},
                                   [&](Kernel& kernel, const WatchedRun& watched) {
                                     const bool on = watched.next() == tick;
                                     if (!on && watched.next() != tick + 4000) {
                                       return;
                                     }
                                     if (what == "feed 0") {
                                       EXPECT_TRUE(kernel.set_overrides({.feed = on ? 0.0 : 1.0}));
                                     } else if (what == "feed stop") {
                                       EXPECT_TRUE(kernel.set_feed_inputs({.stop = on}));
                                     } else if (on) {
                                       kernel.hold();
                                     } else {
                                       kernel.resume();
                                     }
                                   });
      EXPECT_EQ(run.complaint, "");
      EXPECT_GT(run.count(TickStatus::held), 1000);
      EXPECT_FALSE(in_hole(run.first_held()));
      const auto places = of_tap(run);
      ASSERT_EQ(places.size(), of_tap_undisturbed.size());
      for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_NEAR(places[i][0], of_tap_undisturbed[i][0], 1e-9);
        ASSERT_EQ(places[i][1], of_tap_undisturbed[i][1]);
      }
    }
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

// Found with a client: a tick between the order and the look at it had the new speed already, and
// so a run from the record of that look had other ticks.
TEST(Override, OfTheSpindleComesWithTheTickThatThePlansClockKnows) {
  Setpoint setpoint;
  Kernel* ticked = nullptr;
  KernelOptions options{.one_thread = false};
  options.plan_clock = [&](std::int64_t /*ticks*/) {
    if (Kernel* const kernel = std::exchange(ticked, nullptr)) {
      kernel->tick(setpoint);
    }
    return true;
  };
  Kernel kernel(mill(), options);
  kernel.feed("G21 G90 G61 M3 S600\nG1 F600 X40\nM2\n");
  kernel.finish();
  for (int i = 0; i < 100; ++i) {
    kernel.plan();
    kernel.tick(setpoint);
  }
  const double whole_rad_s = setpoint.outputs.spindle_rad_s;
  EXPECT_GT(whole_rad_s, 0.0);
  ticked = &kernel;
  kernel.set_overrides({.spindle = 0.5});
  ASSERT_EQ(ticked, nullptr);
  EXPECT_EQ(setpoint.outputs.spindle_rad_s, whole_rad_s);
  kernel.tick(setpoint);
  EXPECT_EQ(setpoint.outputs.spindle_rad_s, 0.5 * whole_rad_s);
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

// Found with a client: the way down from a rapid to a feedrate that does not follow has some room,
// more of it with each override.
TEST(Override, MayComeOftenBeforeABlockThatDoesNotFollow) {
  const std::string text =
      "G21 G90 G64\nG0 Z5\nS600 M3\nG99 G84 X5 Y5 Z-5 R2 F600\nX10\nG80\nG0 X0\nM2\n";
  constexpr std::int64_t kBetween = 30;
  constexpr std::int64_t kOverrides = 8;
  for (std::int64_t begin = 150; begin < 330; begin += 6) {
    Kernel kernel(default_machine());
    kernel.feed(text);
    kernel.finish();
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    for (std::int64_t tick = 0; status == TickStatus::running; ++tick) {
      const std::int64_t since = tick - begin;
      if (since >= 0 && since < kBetween * kOverrides && since % kBetween == 0) {
        kernel.set_overrides({.feed = since / kBetween % 2 == 0 ? 0.9 : 1.1});
      }
      status = kernel.next(setpoint);
    }
    EXPECT_EQ(status, TickStatus::finished) << "from tick " << begin;
    EXPECT_FALSE(kernel.fault()) << "from tick " << begin << ": " << kernel.fault()->what;
  }
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

}  // namespace
}  // namespace kerf::test
