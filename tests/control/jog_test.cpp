// Motion by hand: steps, continuous jogs, and the way back to a hold.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/control/limit_watch.hpp"
#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

MachineSettings mill_with_travel() {
  MachineSettings settings = mill();
  for (AxisDrive& axis : settings.table.axes) {
    axis.travel = {.min_mm = -100.0, .max_mm = 400.0};
  }
  return settings;
}

struct JogShop : Shop {
  explicit JogShop(const MachineSettings& settings = mill_with_travel())
      : Shop(settings), watch(settings.limits) {
    give(Command::enable);
  }
  State go(int count = 1) {
    State state = State::off;
    for (int i = 0; i < count; ++i) {
      state = tick();
      watch.add(setpoint);
      fastest_mm_s = std::max(fastest_mm_s, setpoint.v_mm_s);
    }
    return state;
  }
  void go_until(State state) {
    for (int i = 0; i < kMaxTicks && go() != state; ++i) {
    }
    ASSERT_EQ(controller.status().state, state);
  }
  void jog(const Jog& jog) {
    const auto given = controller.jog(jog);
    ASSERT_TRUE(given) << given.error().reason;
  }
  ~JogShop() { EXPECT_EQ(watch.complaint(), ""); }

  LimitWatch watch;
  double fastest_mm_s = 0.0;
};

TEST(Jog, StepsByWhatWasAskedFor) {
  JogShop shop;
  shop.jog({.mm = {0.1, -0.2, 0.0}, .is_step = true, .step_mm_s = 5.0});
  EXPECT_EQ(shop.go(), State::jogging);
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{0.1, -0.2, 0.0}));
  EXPECT_LE(shop.fastest_mm_s, 5.0 + 1e-9);
  EXPECT_EQ(shop.controller.status().programs, 0U);
}

TEST(Jog, AddsUpStepsThatComeWhileItMoves) {
  JogShop shop;
  for (int i = 0; i < 4; ++i) {
    shop.jog({.mm = {0.5, 0.0, 0.0}, .is_step = true});
    shop.go(3);
  }
  shop.go_until(State::idle);
  EXPECT_NEAR(shop.setpoint.position_mm[0], 2.0, 1e-12);
}

TEST(Jog, MovesSeveralAxesAlongTheirLineAtTheirSpeeds) {
  JogShop shop;
  const Jog jog{.mm = {30.0, -40.0, 0.0}};
  for (int i = 0; i < 1000; ++i) {
    shop.jog(jog);
    shop.go();
  }
  EXPECT_NEAR(shop.setpoint.v_mm_s, 50.0, 1e-6);
  EXPECT_NEAR(shop.setpoint.velocity_mm_s[0], 30.0, 1e-6);
  EXPECT_NEAR(shop.setpoint.velocity_mm_s[1], -40.0, 1e-6);
  shop.give(Command::stop);
  shop.go_until(State::idle);
  const Position at = shop.setpoint.position_mm;
  EXPECT_NEAR(at[0] / 30.0, at[1] / -40.0, 1e-9);
}

// Nobody renews it: from then on it has the planning time and the way to rest.
TEST(Jog, ThatIsNotRenewedComesToRest) {
  JogShop shop;
  shop.jog({.mm = {50.0, 0.0, 0.0}});
  EXPECT_EQ(shop.go(500), State::jogging);
  EXPECT_NEAR(shop.setpoint.v_mm_s, 50.0, 1e-6);
  EXPECT_EQ(shop.go(150), State::idle);
  const double rest_mm = shop.setpoint.position_mm[0];
  shop.go(100);
  EXPECT_EQ(shop.setpoint.position_mm[0], rest_mm);
  EXPECT_LT(rest_mm, 50.0 * 0.65);
}

TEST(Jog, GoesOnWhileItIsRenewed) {
  JogShop shop;
  for (int i = 0; i < 5; ++i) {
    shop.jog({.mm = {50.0, 0.0, 0.0}});
    EXPECT_EQ(shop.go(450), State::jogging);
  }
  EXPECT_GT(shop.setpoint.position_mm[0], 100.0);
}

TEST(Jog, StopsAtTheTravelBrakingInside) {
  JogShop shop;
  double farthest_mm = 0.0;
  State state = State::jogging;
  for (int i = 0; i < 20'000 && state == State::jogging; ++i) {
    static_cast<void>(shop.controller.jog({.mm = {140.0, 35.0, 0.0}}));
    state = shop.go();
    farthest_mm = std::max(farthest_mm, shop.setpoint.position_mm[0]);
  }
  EXPECT_EQ(state, State::idle);
  EXPECT_EQ(farthest_mm, 400.0);
  EXPECT_EQ(shop.setpoint.position_mm[0], 400.0);
  EXPECT_NEAR(shop.setpoint.position_mm[1], 100.0, 1e-9);
  EXPECT_EQ(shop.controller.jog({.mm = {1.0, 0.0, 0.0}}).error().reason,
            "an axis is at the end of its travel");
  shop.jog({.mm = {-10.0, 0.0, 0.0}, .is_step = true});
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 390.0);
}

TEST(Jog, TurnsToAnotherDirectionFromRest) {
  JogShop shop;
  shop.jog({.mm = {50.0, 0.0, 0.0}});
  shop.go(400);
  shop.jog({.mm = {0.0, 50.0, 0.0}});
  for (int i = 0; i < 8; ++i) {
    shop.jog({.mm = {0.0, 50.0, 0.0}});
    EXPECT_EQ(shop.go(100), State::jogging);
  }
  EXPECT_GT(shop.setpoint.position_mm[1], 10.0);
  shop.give(Command::stop);
  shop.go_until(State::idle);
}

TEST(Jog, IsRefusedWhereItMakesNoSense) {
  JogShop shop;
  EXPECT_EQ(shop.controller.jog({}).error().reason, "no axis is to move");
  EXPECT_EQ(shop.controller.jog({.mm = {NAN, 0.0, 0.0}}).error().reason,
            "a value is out of its range");
  EXPECT_EQ(shop.controller.jog({.extra_rad_mm = {1.0}}).error().reason,
            "the machine has no such axis");
  EXPECT_EQ(shop.controller.jog({.mm = {1.0, 0.0, 0.0}, .is_step = true, .step_mm_s = 0.0})
                .error()
                .reason,
            "a value is out of its range");
  EXPECT_EQ(shop.controller.jog({.mm = {1e-9, 0.0, 0.0}}).error().reason,
            "a value is out of its range");
  EXPECT_EQ(shop.go(), State::idle);
}

TEST(Jog, MayBeAskedForAsFastAsItGoes) {
  JogShop shop;
  shop.jog({.mm = {200.0, 0.0, 0.0}, .is_step = true, .step_mm_s = 1e300});
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 200.0);
  EXPECT_NEAR(shop.fastest_mm_s, 150.0, 1e-3);  // of the path
}

TEST(Jog, IsNoFasterThanTheMachineFileSays) {
  MachineSettings settings = mill_with_travel();
  settings.manual.jog_mm_s = 10.0;
  JogShop shop(settings);
  shop.jog({.mm = {60.0, 80.0, 0.0}});
  shop.go(400);
  EXPECT_NEAR(shop.fastest_mm_s, 10.0, 1e-6);
}

TEST(Jog, TurnsAnAxisThatTheMachineHas) {
  MachineSettings settings = mill_with_travel();
  settings.program.extra_axes = letter_bit('A');
  settings.limits.extra[0] = {
      .velocity_mm_s = 2.0, .acceleration_mm_s2 = 20.0, .jerk_mm_s3 = 500.0};
  settings.table.extra[0] = {.min_rad_mm = -1.0, .max_rad_mm = 1.0};
  JogShop shop(settings);
  shop.jog({.extra_rad_mm = {0.5}, .is_step = true});
  shop.go_until(State::idle);
  EXPECT_NEAR(shop.setpoint.extra_rad_mm[0], 0.5, 1e-12);
  shop.jog({.extra_rad_mm = {3.0}, .is_step = true});
  shop.go_until(State::idle);
  EXPECT_NEAR(shop.setpoint.extra_rad_mm[0], 1.0, 1e-12);
}

TEST(Jog, FromAHoldGoesBackOverItsPlacesBeforeTheProgramGoesOn) {
  const std::string text = "G21 G90 F6000 M3 S100\nG1 X50 Y20\nG2 X100 I25\nG1 X200\nM2\n";
  const Position end = ticks_of(text).back().position_mm;
  JogShop shop;
  shop.start(text);
  shop.go(400);
  shop.give(Command::hold);
  shop.go_until(State::held);
  const Setpoint held = shop.setpoint;
  shop.jog({.mm = {0.0, 0.0, 30.0}, .is_step = true});
  shop.go_until(State::held);
  shop.jog({.mm = {-40.0, 10.0, 0.0}, .is_step = true});
  shop.go_until(State::held);
  EXPECT_EQ(shop.setpoint.outputs, held.outputs);
  EXPECT_EQ(shop.setpoint.line, held.line);
  EXPECT_EQ(shop.setpoint.s_mm, held.s_mm);
  shop.give(Command::resume);
  bool was_above = false;
  while (shop.go() == State::returning) {
    // Not down before it is over the place of the hold.
    const Position& at = shop.setpoint.position_mm;
    was_above = was_above || (at[0] == held.position_mm[0] && at[2] == 30.0);
    ASSERT_TRUE(at[2] == 30.0 || was_above);
  }
  EXPECT_TRUE(was_above);
  EXPECT_EQ(shop.setpoint.position_mm, held.position_mm);
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, end);
  EXPECT_FALSE(shop.controller.program()->fault());
}

// As at a tool change by hand.
TEST(Jog, FromAHoldAtAWaitComesBackBeforeTheAnswer) {
  JogShop shop;
  shop.start("G21 G90 F6000\nG1 X50\nT2 M6\nG1 X90\nM2\n");
  shop.go_until(State::waiting);
  shop.give(Command::hold);
  shop.go_until(State::held);
  shop.jog({.mm = {0.0, 40.0, 0.0}, .is_step = true});
  shop.go_until(State::held);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{50.0, 40.0, 0.0}));
  shop.give(Command::resume);
  shop.go_until(State::running);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{50.0, 0.0, 0.0}));
  for (int i = 0; i < 2000 && shop.go() != State::idle; ++i) {
    static_cast<void>(shop.controller.give(Command::resume));
  }
  EXPECT_EQ(shop.setpoint.position_mm, (Position{90.0, 0.0, 0.0}));
  EXPECT_EQ(shop.setpoint.outputs.tool, 2);
}

TEST(Jog, LetsAToolBeSetMeanwhile) {
  const Tool longer{.number = 2, .pocket = 2, .offset_mm = {0.0, 0.0, 7.0}};
  JogShop idle;
  idle.jog({.mm = {40.0, 0.0, 0.0}, .is_step = true});
  idle.go(10);
  EXPECT_TRUE(idle.controller.set_tool(longer));
  idle.go_until(State::idle);
  JogShop shop;
  shop.start("G21 G90 F6000\nG1 X50\nT2 M6\nG43 H2\nG1 Z1\nM2\n");
  shop.go_until(State::waiting);
  shop.give(Command::hold);
  shop.go_until(State::held);
  shop.jog({.mm = {0.0, 40.0, 0.0}, .is_step = true});
  shop.go_until(State::held);
  EXPECT_TRUE(shop.controller.set_tool(longer));
  shop.give(Command::resume);
  shop.go_until(State::running);
  for (int i = 0; i < 2000 && shop.go() != State::idle; ++i) {
    static_cast<void>(shop.controller.give(Command::resume));
  }
  EXPECT_EQ(shop.setpoint.position_mm, (Position{50.0, 0.0, 8.0}));
}

TEST(Jog, MayBeHeldOnTheWayBack) {
  JogShop shop;
  shop.start("G21 G90\nG1 X200 F6000\nM2\n");
  shop.go(500);
  shop.give(Command::hold);
  shop.go_until(State::held);
  const Position held = shop.setpoint.position_mm;
  shop.jog({.mm = {0.0, 0.0, 100.0}, .is_step = true});
  shop.go_until(State::held);
  shop.give(Command::resume);
  shop.go(200);
  shop.give(Command::hold);
  shop.go_until(State::held);
  EXPECT_GT(shop.setpoint.position_mm[2], 10.0);
  EXPECT_LT(shop.setpoint.position_mm[2], 99.0);
  shop.give(Command::resume);
  shop.go_until(State::running);
  EXPECT_EQ(shop.setpoint.position_mm, held);
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 200.0);
}

TEST(Jog, FromAHoldThatIsStoppedLeavesTheToolWhereItIs) {
  JogShop shop;
  shop.start("G21 G90\nG1 X200 F6000\nM2\n");
  shop.go(500);
  shop.give(Command::hold);
  shop.go_until(State::held);
  shop.jog({.mm = {0.0, 0.0, 20.0}, .is_step = true});
  shop.go_until(State::held);
  shop.give(Command::stop);
  EXPECT_EQ(shop.go(100), State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[2], 20.0);
  shop.start("G21 G90\nG1 X0 F6000\nM2\n");
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{0.0, 0.0, 20.0}));
}

TEST(Jog, EndsInAnEmergencyStopAndTheProgramWithIt) {
  JogShop shop;
  shop.start("G21 G90\nG1 X200 F6000\nM2\n");
  shop.go(500);
  shop.give(Command::hold);
  shop.go_until(State::held);
  shop.jog({.mm = {0.0, 0.0, 100.0}});
  shop.tick(300);
  shop.controller.emergency_stop();
  shop.tick(300);
  EXPECT_FALSE(shop.controller.drives_on());
  const Position at = shop.setpoint.position_mm;
  shop.give(Command::reset);
  shop.give(Command::enable);
  shop.tick(100);
  EXPECT_EQ(shop.setpoint.position_mm, at);
  EXPECT_FALSE(shop.controller.give(Command::resume));
}

TEST(Jog, IsSlowAndWithoutTravelWhileNotHomed) {
  JogShop shop(mill_with_switches());
  shop.jog({.mm = {-1000.0, 0.0, 0.0}, .is_step = true});
  shop.go(2000);
  EXPECT_NEAR(shop.fastest_mm_s, 5.0, 1e-6);
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], -1000.0);
  MachineSettings settings = mill_with_switches();
  settings.manual.unhomed_jog_mm_s = 0.0;
  JogShop forbidden(settings);
  EXPECT_EQ(forbidden.controller.jog({.mm = {1.0, 0.0, 0.0}}).error().reason,
            "the axes are not homed: home first");
}

// Ticks come at any moment of what the other thread does.
TEST(Jog, WorksWithTheTicksInAThreadOfTheirOwn) {
  Controller controller(mill_with_travel());
  ASSERT_TRUE(controller.give(Command::enable));
  LimitWatch watch(mill_with_travel().limits);
  std::atomic<bool> over = false;
  std::thread ticks([&] {
    for (Setpoint setpoint; !over; std::this_thread::sleep_for(std::chrono::microseconds(20))) {
      controller.tick(setpoint);
      watch.add(setpoint);
    }
  });
  const auto wait_for = [&](State state) {
    while (controller.status().state != state) {
      controller.plan();
    }
  };
  ASSERT_TRUE(controller.give(Command::start));
  controller.feed("G21 G90\nG1 X300 F600\nM2\n");  // 30,000 ticks
  controller.finish();
  for (int i = 0; i < 20; ++i) {
    wait_for(State::running);
    ASSERT_TRUE(controller.give(Command::hold));
    wait_for(State::held);
    ASSERT_TRUE(controller.jog({.mm = {0.0, 0.0, 2.0}, .is_step = true}));
    wait_for(State::held);
    ASSERT_EQ(controller.status().setpoint.position_mm[2], 2.0);
    ASSERT_TRUE(controller.give(Command::resume));
    wait_for(State::running);
    EXPECT_EQ(controller.status().setpoint.position_mm[2], 0.0);
  }
  ASSERT_TRUE(controller.set_overrides({.feed = 2.0}));
  wait_for(State::idle);
  over = true;
  ticks.join();
  EXPECT_EQ(watch.complaint(), "");
  EXPECT_EQ(controller.status().setpoint.position_mm[0], 300.0);
  EXPECT_FALSE(controller.program()->fault());
}

// Anything at any tick: limits at each tick, inside the travel, and the program's end is reached.
TEST(Jog, AtRandomTicksKeepsLimitsAndTravel) {
  constexpr unsigned kSeed = 20'260'100;
  for (unsigned seed = kSeed; seed < kSeed + 12; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto upto = [&random](int most) {
      return static_cast<int>(random() % (static_cast<unsigned>(most) + 1U));
    };
    const auto some = [&] { return static_cast<double>(upto(400) - 200) * 0.3; };
    JogShop shop;
    shop.start("G21 G90 F6000\nG1 X80 Y30\nG3 X20 Y90 R60\nG1 Z-20\nX0 Y0\nM2\n");
    for (int i = 0; i < 60; ++i) {
      shop.go(upto(120));
      switch (upto(6)) {
        case 0:
          static_cast<void>(shop.controller.give(Command::hold));
          break;
        case 1:
          static_cast<void>(shop.controller.give(Command::resume));
          break;
        case 2:
          static_cast<void>(shop.controller.jog({.mm = {some(), some(), some()}, .is_step = true}));
          break;
        default:
          static_cast<void>(shop.controller.jog({.mm = {some(), some(), upto(1) * some()}}));
          break;
      }
      for (const double at_mm : shop.setpoint.position_mm) {
        ASSERT_GE(at_mm, -100.0 - 1e-6);
        ASSERT_LE(at_mm, 400.0 + 1e-6);
      }
      ASSERT_EQ(shop.watch.complaint(), "");
    }
    for (int i = 0; i < kMaxTicks && shop.go() != State::idle; ++i) {
      static_cast<void>(shop.controller.give(Command::resume));
    }
    EXPECT_EQ(shop.controller.status().state, State::idle);
    EXPECT_FALSE(shop.controller.program()->fault());
  }
}

}  // namespace
}  // namespace kerf::test
