// What an operator sees where the text of a program is late.
#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

// Its text comes piece by piece, and says nothing of its end.
struct LateText : Shop {
  LateText() {
    give(Command::enable);
    give(Command::start);
  }
  void tick(int count) {
    for (int i = 0; i < count; ++i) {
      if (controller.plan()) {
        controller.text_is_late();
      }
      controller.tick(setpoint);
    }
  }
  void tick_until(State state) {
    for (int i = 0; i < 2000 && controller.status().state != state; ++i) {
      tick(1);
    }
    ASSERT_EQ(controller.status().state, state);
  }
  void goes_on_with_the_text() {
    EXPECT_EQ(controller.status().waits_for, WaitsFor::text);
    controller.feed("G1 X2\n");
    controller.finish();
    tick_until(State::idle);
    EXPECT_EQ(setpoint.position_mm[0], 2.0);
  }
};

// Found with a client: it was said to run.
TEST(Controller, WaitsForTextBehindAWaitThatIsAnswered) {
  LateText shop;
  shop.controller.feed("G21 G90 G1 X1 F600\nM0\n");
  shop.tick(1000);
  ASSERT_EQ(shop.controller.status().waits_for, WaitsFor::answer);
  shop.give(Command::resume);
  shop.tick(50);
  EXPECT_EQ(shop.controller.status().state, State::waiting);
  shop.goes_on_with_the_text();
}

TEST(Controller, WaitsForTextBehindAHoldAsItDidBefore) {
  LateText shop;
  shop.controller.feed("G21 G90\nG1 X1 F3000\n");
  shop.tick_until(State::waiting);
  shop.give(Command::hold);
  shop.tick_until(State::held);
  shop.give(Command::resume);
  shop.tick_until(State::waiting);
  shop.goes_on_with_the_text();
}

// Its block was over before the hold, and what the text brings is another one.
TEST(Controller, WaitsBehindABlockInSingleBlockThoughAHoldCameBeforeTheText) {
  for (const bool holds : {false, true}) {
    LateText shop;
    ASSERT_TRUE(shop.controller.set_single_block(true));
    shop.controller.feed("G21 G90\nG1 X1 F3000\n");
    shop.tick_until(State::waiting);
    if (holds) {
      shop.give(Command::hold);
      shop.tick_until(State::held);
      shop.give(Command::resume);
      shop.tick_until(State::waiting);
    }
    shop.controller.feed("G1 X2\n");
    shop.controller.finish();
    shop.tick(500);
    EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::answer) << holds;
    EXPECT_EQ(shop.setpoint.position_mm[0], 1.0) << holds;
    shop.give(Command::resume);
    shop.tick(500);
    EXPECT_EQ(shop.setpoint.position_mm[0], 2.0) << holds;
  }
}

// Found with a client: it was said to wait for planning, so nobody stopped it once its client left.
TEST(Controller, IsHeldByTheFeedWhereTextHasComeThatWasLate) {
  LateText shop;
  shop.controller.feed("G21 G90\nG1 X1 F3000\n");
  shop.tick_until(State::waiting);
  ASSERT_TRUE(shop.controller.set_overrides({.feed = 0.0}));
  shop.tick(50);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::text);
  shop.controller.feed("G1 X2\n");
  shop.tick(50);
  EXPECT_EQ(shop.controller.status().state, State::running);
  EXPECT_TRUE(shop.controller.status().is_held_by_feed);
  ASSERT_TRUE(shop.controller.set_overrides({}));
  shop.tick_until(State::waiting);
  EXPECT_EQ(shop.setpoint.position_mm[0], 2.0);
  shop.controller.finish();
  shop.tick_until(State::idle);
}

}  // namespace
}  // namespace kerf::test
