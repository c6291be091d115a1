#include "programs/kerf/control/operator.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "tests/control/shop.hpp"

namespace kerf::program {
namespace {

using test::Shop;
using State = ControllerState;

// A round of the thread that plans, and a tick after it.
void tick(Operator& by, Shop& shop, int count = 1) {
  for (int i = 0; i < count; ++i) {
    by.carry_out();
    shop.tick();
  }
}

// late: all switches are found, and the tool is on its last way.
void tick_into_search(Operator& by, Shop& shop, bool late) {
  tick(by, shop, 50);
  for (int i = 0; i < test::kMaxTicks && late && shop.controller.status().unhomed != 0; ++i) {
    tick(by, shop);
  }
}

void expect_refused(const tl::expected<void, Refusal>& given, const std::string& reason) {
  ASSERT_FALSE(given);
  EXPECT_EQ(given.error().reason, reason);
}

TEST(Operator, StartsTheProgramOnceItsAxesAreHomed) {
  Shop shop(test::mill_with_switches());
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  ASSERT_TRUE(by.home_and_start());
  for (int i = 0; i < test::kMaxTicks && !by.has_started(); ++i) {
    tick(by, shop);
  }
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::text);
  EXPECT_EQ(shop.controller.status().unhomed, 0U);
  EXPECT_FALSE(by.has_stopped());
}

TEST(Operator, FollowsTheInputsOfTheMachineThatTheMachineFileNames) {
  Shop shop;
  Operator by(shop.controller, true, nullptr, {.adaptive_feed = 2, .feed_stop = 5});
  const auto followed_of = [&](double share, std::uint64_t digital) {
    machine::MachineInputs said;
    said.analog.fill(0.25);
    said.analog[2] = share;
    said.digital = digital;
    by.hear(said);
    by.carry_out();
    return shop.controller.status().feed_inputs;
  };
  EXPECT_EQ(followed_of(0.7, ~(1ULL << 5U)), (FeedInputs{.adaptive = 0.7}));
  EXPECT_EQ(followed_of(0.7, 1ULL << 5U), (FeedInputs{.adaptive = 0.7, .stop = true}));
  EXPECT_EQ(followed_of(0.704, 0), (FeedInputs{.adaptive = 0.704})) << "with another change";
  EXPECT_EQ(followed_of(0.7, 0), (FeedInputs{.adaptive = 0.704})) << "noise";
  EXPECT_EQ(followed_of(0.998, 0), (FeedInputs{.adaptive = 0.998}));
  EXPECT_EQ(followed_of(1.5, 0), FeedInputs{});
  EXPECT_EQ(followed_of(0.004, 0), (FeedInputs{.adaptive = 0.004}));
  EXPECT_EQ(followed_of(-1.0, 0), (FeedInputs{.adaptive = 0.0}));
  EXPECT_EQ(followed_of(0.5, 0), (FeedInputs{.adaptive = 0.5}));
  EXPECT_EQ(followed_of(std::nan(""), 0), (FeedInputs{.adaptive = 0.0}));
}

TEST(Operator, FollowsNoInputThatTheMachineFileDoesNotName) {
  Shop shop;
  Operator by(shop.controller, true);
  machine::MachineInputs said;
  said.digital = ~0ULL;
  by.hear(said);
  by.carry_out();
  EXPECT_EQ(shop.controller.status().feed_inputs, FeedInputs{});
}

// Found with a client: a stop in the last way of the search let the program begin.
TEST(Operator, StartsNoProgramWhereTheSearchForHomeIsStopped) {
  for (const bool is_late : {false, true}) {
    Shop shop(test::mill_with_switches());
    Operator by(shop.controller, true);
    shop.give(kerf::Command::enable);
    ASSERT_TRUE(by.home_and_start());
    tick_into_search(by, shop, is_late);
    ASSERT_EQ(shop.controller.status().state, State::homing);
    ASSERT_TRUE(by.give(kerf::Command::stop));
    tick(by, shop, 2000);
    EXPECT_EQ(shop.controller.status().state, State::idle);
    EXPECT_FALSE(by.has_started());
    EXPECT_TRUE(by.has_stopped());
  }
}

// Found by reading: a door that was closed again before the search had come to rest let it begin.
TEST(Operator, StartsNoProgramWhereTheDoorEndsTheSearchForHome) {
  for (const bool is_late : {false, true}) {
    Shop shop(test::mill_with_switches());
    Operator by(shop.controller, true);
    shop.give(kerf::Command::enable);
    ASSERT_TRUE(by.home_and_start());
    tick_into_search(by, shop, is_late);
    shop.controller.set_door(true);
    tick(by, shop, 3);
    shop.controller.set_door(false);
    tick(by, shop, 2000);
    EXPECT_EQ(shop.controller.status().state, State::idle);
    EXPECT_FALSE(by.has_started());
    EXPECT_TRUE(by.has_stopped());
  }
}

// Found by reading: the tick at which a move by hand ended was there before the stop, which was
// taken for that move's.
TEST(Operator, EndsTheProgramWhereAMoveByHandEndsBeforeTheStopIsHeard) {
  Shop shop;
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  ASSERT_TRUE(by.give(kerf::Command::start));
  shop.controller.feed("G21 G90 G1 F600 X20\nM2\n");
  shop.controller.finish();
  tick(by, shop, 300);
  ASSERT_TRUE(by.give(kerf::Command::hold));
  shop.tick_until(State::held);
  ASSERT_TRUE(by.give(Jog{.mm = {1.0}, .is_step = true}));
  tick(by, shop, 20);
  ASSERT_EQ(shop.controller.status().state, State::jogging);
  Setpoint setpoint;
  for (int i = 0; i < 2000; ++i) {
    shop.controller.tick(setpoint);
  }
  ASSERT_TRUE(by.give(kerf::Command::stop));
  tick(by, shop, 500);
  EXPECT_EQ(shop.controller.status().state, State::idle);
  EXPECT_TRUE(by.has_stopped());
}

int ticks_of_search() {
  Shop shop(test::mill_with_switches());
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  EXPECT_TRUE(by.give(kerf::Command::home));
  int ticks = 0;
  for (; ticks < test::kMaxTicks && shop.controller.status().state != State::idle; ++ticks) {
    tick(by, shop);
  }
  return ticks;
}

TEST(Operator, StartsNoProgramWhereTheSearchForHomeEndsBeforeTheStopIsHeard) {
  Shop shop(test::mill_with_switches());
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  ASSERT_TRUE(by.home_and_start());
  tick(by, shop, ticks_of_search() - 20);
  Setpoint setpoint;
  for (int i = 0; i < 100; ++i) {
    shop.controller.tick(setpoint);
  }
  ASSERT_EQ(shop.controller.status().state, State::homing);
  EXPECT_TRUE(by.give(kerf::Command::stop));
  tick(by, shop, 500);
  EXPECT_EQ(shop.controller.status().state, State::idle);
  EXPECT_FALSE(by.has_started());
  EXPECT_TRUE(by.has_stopped());
}

// Found by reading: a key in the last milliseconds of a run was carried out once the keyboard was
// gone.
TEST(Operator, CarriesOutNothingOfWhoIsGone) {
  Shop shop;
  Operator by(shop.controller, true);
  int done = 0;
  const int gone = 0;
  const int stays = 0;
  by.ask(&gone, [&done] { done += 1; });
  by.ask(&stays, [&done] { done += 10; });
  by.drop_orders(&gone);
  by.carry_out();
  EXPECT_EQ(done, 10);
}

// Found with a client: what came between the last tick and the end of the run replaced the program
// that the report is about, or was accepted, and nothing moved.
TEST(Operator, BeginsNothingBehindTheProgram) {
  Shop shop;
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  ASSERT_TRUE(by.give(MdiLine{.text = "G0 X1"}));
  shop.tick_until(State::idle);
  ASSERT_TRUE(by.give(kerf::Command::start));
  shop.controller.feed("G21 G90 G1 F600 X2\nM2\n");
  shop.controller.finish();
  shop.tick_until(State::idle);
  const Kernel* const program = shop.controller.program();
  expect_refused(by.give(kerf::Command::start), "the run is over");
  expect_refused(by.give(MdiLine{.text = "G1 X9999"}), "the run is over");
  expect_refused(by.give(Jog{.mm = {1.0}, .is_step = true}), "the run is over");
  expect_refused(by.give(kerf::Command::home), "the run is over");
  EXPECT_EQ(shop.controller.program(), program);
  EXPECT_TRUE(by.give(Overrides{.feed = 0.5}));
}

// Found with a client: a stop by the system before the program was given once, in vain, and what
// began after it waited for its text for ever.
TEST(Operator, BeginsNothingOnceTheRunEnds) {
  Shop shop;
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  by.end_run();
  EXPECT_TRUE(by.has_stopped());
  expect_refused(by.give(kerf::Command::start), "the run ends");
  expect_refused(by.give(MdiLine{.text = "G0 X1"}), "the run ends");
  EXPECT_FALSE(by.has_started());
}

TEST(Operator, GoesOnNoMoreWithAJogOnceTheRunEnds) {
  Shop shop;
  Operator by(shop.controller, true);
  shop.give(kerf::Command::enable);
  ASSERT_TRUE(by.give(Jog{.mm = {20.0}}));
  tick(by, shop, 200);
  by.end_run();
  ASSERT_TRUE(shop.controller.give(kerf::Command::stop));
  for (int i = 0; i < 1000; ++i) {
    static_cast<void>(by.give(Jog{.mm = {20.0}}));
    tick(by, shop);
  }
  EXPECT_EQ(shop.controller.status().state, State::idle);
}

}  // namespace
}  // namespace kerf::program
