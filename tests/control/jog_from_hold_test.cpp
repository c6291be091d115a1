// Motion by hand while a program is held, and the way back.
#include <atomic>
#include <chrono>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "tests/control/jog_shop.hpp"

namespace kerf::test {
namespace {

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

// Found with a client: it was followed in the hold, and no more once the tool had been jogged.
TEST(Jog, FromAHoldLeavesASpindleThatFollowsItsOverride) {
  JogShop shop;
  constexpr double kWhole_rad_s = 600.0 * 2.0 * 3.14159265358979323846 / 60.0;
  const auto override_by = [&](double share) {
    ASSERT_TRUE(shop.controller.set_overrides({.spindle = share}));
    shop.go(3);
    EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, share * kWhole_rad_s, 1e-9);
  };
  shop.start("G21 G90 F6000 M3 S600\nG1 X200\nM2\n");
  shop.go(400);
  shop.give(Command::hold);
  shop.go_until(State::held);
  override_by(0.5);
  shop.jog({.mm = {0.0, 5.0, 0.0}, .is_step = true});
  shop.go_until(State::held);
  override_by(0.1);
  override_by(1.5);
  shop.give(Command::resume);
  while (shop.go() != State::idle) {
    ASSERT_NEAR(shop.setpoint.outputs.spindle_rad_s, 1.5 * kWhole_rad_s, 1e-9);
  }
}

// By which a program goes on another day.
TEST(Jog, FromAHoldLeavesTheBlockOfTheProgram) {
  JogShop shop;
  shop.start("G21 G90 G61 F6000\nG1 X10\nX20\nX30\nX200\nM2\n");
  shop.go(900);
  shop.give(Command::hold);
  shop.go_until(State::held);
  const std::uint64_t block = shop.controller.status().block;
  EXPECT_GE(block, 4U);
  shop.jog({.mm = {0.0, 0.0, 30.0}, .is_step = true});
  int ticks = 0;
  for (; shop.go() == State::jogging; ++ticks) {
    ASSERT_EQ(shop.controller.status().block, block);
  }
  EXPECT_GT(ticks, 100);
  EXPECT_EQ(shop.setpoint.position_mm[2], 30.0);
  EXPECT_EQ(shop.controller.status().block, block);
  shop.give(Command::resume);
  for (ticks = 0; shop.go() == State::returning; ++ticks) {
    ASSERT_EQ(shop.controller.status().block, block);
  }
  EXPECT_GT(ticks, 100);
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
  shop.go_until(State::waiting);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::answer);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{50.0, 0.0, 0.0}));
  shop.give(Command::resume);
  shop.go_until(State::idle);
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
  shop.go_until(State::waiting);
  shop.give(Command::resume);
  shop.go_until(State::idle);
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
