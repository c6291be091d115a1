// An open door: what moves comes to rest, and nothing begins to move.
#include <array>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

constexpr const char* kLineOf300 = "G21 G90\nG1 X300 F6000\nM2\n";

void expect_refused(const tl::expected<void, Refusal>& given, State state) {
  ASSERT_FALSE(given);
  EXPECT_EQ(given.error().reason, "the door is open");
  EXPECT_EQ(given.error().state, state);
}

TEST(Doors, HoldAProgramInMotionWithinTwentyMilliseconds) {
  Shop shop;
  shop.begin(kLineOf300);
  const double v_mm_s = shop.setpoint.v_mm_s;
  ASSERT_GT(v_mm_s, 50.0);
  shop.controller.set_door(true);
  shop.tick(20);
  EXPECT_EQ(shop.controller.status().state, State::holding);
  EXPECT_LT(shop.setpoint.v_mm_s, v_mm_s);
  shop.tick_until(State::held);
  EXPECT_TRUE(shop.controller.status().door_open);
}

TEST(Doors, LetAProgramGoOnAtAResumeOnceTheyAreClosed) {
  Shop shop;
  shop.begin(mixed_program());
  shop.controller.set_door(true);
  shop.tick_until(State::held);
  expect_refused(shop.controller.give(Command::resume), State::held);
  shop.controller.set_door(false);
  EXPECT_EQ(shop.tick(200), State::held);  // not by itself
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, ticks_of(mixed_program()).back().position_mm);
}

// Found with a client: a jog that was given while the one before it stopped went on.
TEST(Doors, StopAJogThatBeganBehindAStopToo) {
  for (const bool opens_early : {false, true}) {
    Shop shop;
    shop.give(Command::enable);
    ASSERT_TRUE(shop.controller.jog({.mm = {20.0}}));
    shop.tick(300);
    shop.give(Command::stop);
    ASSERT_TRUE(shop.controller.jog({.mm = {100.0}, .is_step = true, .step_mm_s = 20.0}));
    shop.tick(opens_early ? 2 : 500);
    ASSERT_EQ(shop.controller.status().state, State::jogging);
    shop.controller.set_door(true);
    shop.tick(300);
    EXPECT_EQ(shop.controller.status().state, State::idle);
    EXPECT_EQ(shop.setpoint.v_mm_s, 0.0);
    EXPECT_LT(shop.setpoint.position_mm[0], 20.0);
  }
}

// Found by reading: the move that was to follow began, and was stopped then.
TEST(Doors, LetNothingFollowThatOpenAsAMoveByHandComesToRest) {
  for (int opens_behind = 0; opens_behind < 4; ++opens_behind) {
    Shop shop;
    shop.give(Command::enable);
    ASSERT_TRUE(shop.controller.jog({.mm = {1.0}, .is_step = true, .step_mm_s = 20.0}));
    ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 5.0}, .is_step = true, .step_mm_s = 20.0}));
    for (int ticks = 0; shop.setpoint.position_mm[0] < 1.0 && ticks < 1000; ++ticks) {
      shop.tick();
    }
    // At rest there; the first tick sees it, whose plan() begins the move.
    ASSERT_EQ(shop.setpoint.position_mm[1], 0.0);
    for (int i = 0; i < opens_behind; ++i) {
      shop.controller.tick(shop.setpoint);
    }
    shop.controller.set_door(true);
    shop.controller.plan();
    for (int i = 0; i < 100; ++i) {
      shop.tick();
    }
    EXPECT_EQ(shop.controller.status().state, State::idle);
    EXPECT_EQ(shop.setpoint.position_mm, (Position{1.0, 0.0, 0.0})) << opens_behind;
    EXPECT_NE(shop.told().find("the door is open"), std::string::npos) << shop.told();
  }
}

TEST(Doors, MayBeOpenWhileAProgramWaitsForAnAnswer) {
  Shop shop;
  shop.give(Command::enable);
  shop.start("G21 G90 F3000\nG1 X1\nM0\nX20\nM2\n");
  shop.tick_until(State::waiting);
  shop.controller.set_door(true);
  EXPECT_EQ(shop.tick(200), State::waiting);
  expect_refused(shop.controller.give(Command::resume), State::waiting);
  shop.controller.set_door(false);
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 20.0);
}

TEST(Doors, HoldAProgramThatWaitsForText) {
  Shop shop;
  shop.give(Command::enable);
  shop.give(Command::start);
  shop.controller.feed("G21 G90 F3000\nG1 X1\n");
  shop.tick_until(State::waiting);
  ASSERT_EQ(shop.controller.status().waits_for, WaitsFor::text);
  shop.controller.set_door(true);
  shop.tick_until(State::held);
  shop.controller.feed("X20\nM2\n");
  shop.controller.finish();
  EXPECT_EQ(shop.tick(500), State::held);
  EXPECT_LE(shop.setpoint.position_mm[0], 1.0);
}

TEST(Doors, LetNothingBegin) {
  Shop shop(mill_with_switches());
  shop.give(Command::enable);
  shop.controller.set_door(true);
  shop.tick(5);
  expect_refused(shop.controller.give(Command::start), State::idle);
  expect_refused(shop.controller.give(Command::home), State::idle);
  expect_refused(shop.controller.run_mdi("G1 X1 F600"), State::idle);
  expect_refused(shop.controller.jog({.mm = {1.0}, .is_step = true}), State::idle);
  EXPECT_EQ(shop.tick(100), State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
}

TEST(Doors, StopAJogAndHoming) {
  Shop shop(mill_with_switches());
  shop.give(Command::enable);
  ASSERT_TRUE(shop.controller.jog({.mm = {5.0}}));
  ASSERT_EQ(shop.tick(50), State::jogging);
  shop.controller.set_door(true);
  shop.tick_until(State::idle);
  const double jogged_mm = shop.setpoint.position_mm[0];
  EXPECT_GT(jogged_mm, 0.0);
  shop.controller.set_door(false);
  shop.give(Command::home);
  ASSERT_EQ(shop.tick(50), State::homing);
  shop.controller.set_door(true);
  shop.tick_until(State::idle);
  EXPECT_NE(shop.controller.status().unhomed, 0);
  EXPECT_EQ(shop.setpoint.v_mm_s, 0.0);
}

TEST(Doors, AreToldOnceEachTimeTheyStopAMotion) {
  Shop shop;
  shop.begin(kLineOf300);
  const std::uint64_t before = shop.controller.status().next_event;
  shop.controller.set_door(true);
  shop.tick_until(State::held);
  shop.tick(50);
  std::array<ControllerEvent, 16> events;
  const std::size_t count = shop.controller.events_since(before, events);
  int told = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (events.at(i).kind == ControllerEvent::Kind::message) {
      ++told;
      EXPECT_EQ(shop.controller.message(events.at(i).message)->text, "the door is open");
    }
  }
  EXPECT_EQ(told, 1);
}

}  // namespace
}  // namespace kerf::test
