// What an operator sees and is told, from any thread.
#include <algorithm>
#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

TEST(Controller, SaysWhatItWaitsFor) {
  Shop shop;
  shop.give(Command::enable);
  shop.give(Command::start);
  shop.controller.feed("G21 G90\nG1 X1 F3000\n");
  shop.controller.plan();
  shop.controller.text_is_late();
  shop.tick_until(State::waiting);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::text);
  EXPECT_EQ(shop.controller.give(Command::resume).error().reason, "it waits for no answer");
  EXPECT_EQ(shop.setpoint.position_mm[0], 1.0);
  shop.controller.feed("G1 X200\n");
  shop.controller.finish();
  shop.tick_until(State::running);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::nothing);
  State state = State::running;
  for (int i = 0; i < 1000 && state == State::running; ++i) {
    state = shop.controller.tick(shop.setpoint);
  }
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::planning);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 200.0);
}

TEST(Controller, SaysThatTheFeedHoldsIt) {
  Shop shop;
  shop.give(Command::enable);
  shop.give(Command::start);
  shop.controller.feed("G21 G90\nM52 P1 G1 X200 F600\nM53 P0 X400\nM2\n");
  shop.controller.finish();
  shop.tick(100);
  const auto is_held = [&shop] {
    shop.tick(300);
    return shop.controller.status().is_held_by_feed;
  };
  EXPECT_FALSE(is_held());
  for (const auto& [feed, inputs] : {std::pair{0.0, FeedInputs{}},
                                     {1.0, FeedInputs{.stop = true}},
                                     {1.0, FeedInputs{.adaptive = 0.0}}}) {
    ASSERT_TRUE(shop.controller.set_overrides({.feed = feed}));
    ASSERT_TRUE(shop.controller.set_feed_inputs(inputs));
    EXPECT_TRUE(is_held());
    EXPECT_EQ(shop.controller.status().state, State::running);
    shop.give(Command::hold);
    EXPECT_FALSE(is_held());  // by the operator
    shop.give(Command::resume);
    EXPECT_TRUE(is_held());
    ASSERT_TRUE(shop.controller.set_overrides({}));
    ASSERT_TRUE(shop.controller.set_feed_inputs({}));
    EXPECT_FALSE(is_held());
  }
  shop.tick(25000);
  ASSERT_EQ(shop.controller.status().setpoint.line, 3U);
  ASSERT_TRUE(shop.controller.set_feed_inputs({.stop = true}));
  EXPECT_FALSE(is_held());  // it goes on under M53 P0
  EXPECT_GT(shop.setpoint.v_mm_s, 0.0);
}

TEST(Controller, SaysThatItWaitsForTheMachine) {
  Controller controller(mill(), {.asks_machine = true});
  ASSERT_TRUE(controller.give(Command::enable));
  ASSERT_TRUE(controller.give(Command::start));
  controller.feed("G21 G90 G1 X1 F600\nM66 P5 L0\nM66 P5 L3 Q9\nG1 X2\nM2\n");
  controller.finish();
  Setpoint setpoint;
  const auto tick = [&](int count) {
    for (int i = 0; i < count; ++i) {
      controller.plan();
      controller.tick(setpoint);
    }
    return controller.status();
  };
  EXPECT_EQ(tick(500).state, State::waiting);
  EXPECT_EQ(tick(1).waits_for, WaitsFor::machine);
  EXPECT_EQ(controller.give(Command::resume).error().reason, "it waits for no answer");
  ASSERT_TRUE(controller.give(Command::hold));
  EXPECT_EQ(tick(1).state, State::holding);
  EXPECT_EQ(tick(1).waits_for, WaitsFor::machine);
  controller.set_program_inputs({.digital = 1U << 5U});
  EXPECT_EQ(tick(100).state, State::held);
  EXPECT_EQ(tick(1).waits_for, WaitsFor::nothing);
  ASSERT_TRUE(controller.give(Command::resume));
  EXPECT_EQ(tick(1000).state, State::idle);
  EXPECT_EQ(setpoint.position_mm[0], 2.0);
  // What is answered at once is no wait.
  std::array<ControllerEvent, ControllerEvent::kKept> events;
  const std::size_t count = controller.events_since(1, events);
  EXPECT_EQ(std::count_if(events.begin(), events.begin() + static_cast<std::ptrdiff_t>(count),
                          [](const ControllerEvent& event) {
                            return event.kind == ControllerEvent::Kind::state &&
                                   event.state == State::waiting;
                          }),
            1);
}

// A thread that had changed the state could tell of it after the one that changed it next.
TEST(Controller, TellsLastOfTheStateThatItIsInWhicheverThreadChangedIt) {
  for (int round = 0; round < 300; ++round) {
    Shop shop;
    std::thread button([&] {
      for (int i = 0; i < 20; ++i) {
        shop.controller.emergency_stop();
      }
    });
    for (int i = 0; i < 20; ++i) {
      static_cast<void>(shop.controller.give(Command::reset));
      static_cast<void>(shop.controller.give(Command::enable));
    }
    button.join();
    std::array<ControllerEvent, ControllerEvent::kKept> events;
    const std::size_t count = shop.controller.events_since(1, events);
    ASSERT_GT(count, 0U);
    ASSERT_EQ(events[count - 1].state, shop.controller.status().state) << round;
  }
}

// On this line X is the path length, of one tick or of another, never of two.
TEST(Controller, ShowsEachThreadAWholeTick) {
  Shop shop;
  shop.begin("G21 G90\nG1 X1000 F6000\nM2\n");
  std::atomic<bool> over = false;
  std::atomic<int> seen = 0;
  std::atomic<int> torn = 0;
  std::thread reader([&] {
    while (!over) {
      const ControllerStatus status = shop.controller.status();
      torn += status.setpoint.position_mm[0] != status.setpoint.s_mm ? 1 : 0;
      ++seen;
    }
  });
  while (seen < 100 || shop.controller.status().state != State::idle) {
    shop.tick();
  }
  over = true;
  reader.join();
  EXPECT_EQ(torn, 0);
}

// Ticks come while the answer is carried out.
TEST(Controller, WaitsOnceAtEachStop) {
  constexpr int kStops = 200;
  std::string text = "G21 G91 F6000\n";
  for (int i = 0; i < kStops; ++i) {
    text += "G1 X0.1\nM0\n" + std::string(i % 3 == 0 ? "M0\n" : "");
  }
  Controller controller{mill()};
  ASSERT_TRUE(controller.give(Command::enable));
  ASSERT_TRUE(controller.give(Command::start));
  controller.feed(text + "M2\n");
  controller.finish();
  controller.plan();
  std::atomic<bool> over = false;
  std::thread ticks([&] {
    for (Setpoint setpoint; !over;) {
      controller.tick(setpoint);
    }
  });
  int answers = 0;
  int waits = 0;
  for (std::uint64_t next = 1; controller.status().state != State::idle;) {
    std::array<ControllerEvent, ControllerEvent::kKept> events;
    const std::size_t count = controller.events_since(next, events);
    for (std::size_t i = 0; i < count; ++i) {
      next = events[i].number + 1;
      waits += events[i].waits_for == WaitsFor::answer ? 1 : 0;
      if (events[i].waits_for == WaitsFor::answer) {
        answers += controller.give(Command::resume) ? 1 : 0;
      }
    }
    controller.plan();
  }
  over = true;
  ticks.join();
  EXPECT_EQ(waits, kStops + (kStops + 2) / 3);
  EXPECT_EQ(answers, waits);
}

TEST(Controller, TellsEachChangeOfStateAndEachMessageOnce) {
  Shop shop;
  shop.give(Command::enable);
  shop.start("G21 G90 F6000\nG1 X50\n(MSG, tool 2)\nM0\nX100 (DEBUG, at #5420)\nM2\n");
  shop.tick_until(State::waiting);
  shop.tick();
  shop.give(Command::resume);
  shop.tick(100);
  shop.give(Command::hold);
  shop.tick_until(State::held);
  shop.give(Command::hold);  // it is held already: no event
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  shop.tick();
  std::array<ControllerEvent, 64> events;
  const std::size_t count = shop.controller.events_since(1, events);
  std::vector<std::string> told;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(events[i].number, i + 1);
    const auto message = shop.controller.message(events[i].message);
    told.emplace_back(message ? message->text : name_of(events[i].state));
  }
  EXPECT_EQ(told, (std::vector<std::string>{"idle", "running", "tool 2", "waiting", "running",
                                            "at 50.000000", "holding", "held", "running", "idle"}));
  EXPECT_EQ(events[3].waits_for, WaitsFor::answer);
  EXPECT_EQ(events[3].line, 4);
  EXPECT_EQ(shop.controller.status().next_event, count + 1);
}

// Found with a client: before the first motion, and between two waits in a row, nothing was planned
// that a message could be told ahead of.
TEST(Controller, TellsMessagesBeforeTheWaitThatTheyComeWithThoughNothingMoves) {
  Shop shop;
  shop.give(Command::enable);
  shop.start("(MSG, first)\nM0\n(MSG, second)\nM0\nG21 G90 G1 X1 F600\nM2\n");
  shop.tick_until(State::waiting);
  shop.tick(20);
  shop.give(Command::resume);
  shop.tick(20);
  ASSERT_EQ(shop.controller.status().state, State::waiting);
  std::array<ControllerEvent, 16> events;
  const std::size_t count = shop.controller.events_since(1, events);
  std::vector<std::string> told;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_message = events.at(i).kind == ControllerEvent::Kind::message;
    told.emplace_back(is_message ? shop.controller.message(events.at(i).message)->text
                                 : std::string(name_of(events.at(i).state)));
  }
  EXPECT_EQ(told, (std::vector<std::string>{"idle", "running", "first", "waiting", "running",
                                            "second", "waiting"}));
}

TEST(Controller, SaysWhatAsksForAnAnswer) {
  Shop shop;
  shop.give(Command::enable);
  ASSERT_TRUE(shop.controller.set_optional_stop(true));
  shop.start("G21 G90 F6000\nM0\nG1 X1\nM1\nX2\nM60\nX3\nT1 M6\nX4\nX5\nM2\n");
  for (const WaitCause cause :
       {WaitCause::program_stop, WaitCause::optional_stop, WaitCause::pallet_change,
        WaitCause::tool_change, WaitCause::block_end}) {
    shop.tick_until(State::waiting);
    EXPECT_EQ(shop.controller.status().wait_cause, cause) << name_of(cause);
    std::array<ControllerEvent, 1> last;
    ASSERT_EQ(shop.controller.events_since(shop.controller.status().next_event - 1, last), 1U);
    EXPECT_EQ(last[0].state, State::waiting);
    EXPECT_EQ(last[0].wait_cause, cause);
    if (cause == WaitCause::tool_change) {
      ASSERT_TRUE(shop.controller.set_single_block(true));
    } else if (cause == WaitCause::block_end) {
      ASSERT_TRUE(shop.controller.set_single_block(false));
    }
    shop.give(Command::resume);
    shop.tick();
    EXPECT_EQ(shop.controller.status().wait_cause, WaitCause::none);
  }
  shop.tick_until(State::idle);
}

TEST(Controller, ShowsTheCodesInForceWhereTheToolIs) {
  Shop shop;
  shop.begin("G21 G90 G61\nG1 X100 F6000\nG20 G1 X5\nM2\n");
  EXPECT_NE(std::string(shop.controller.status().codes.data()).find("G21"), std::string::npos);
  shop.tick(1000);
  EXPECT_NE(std::string(shop.controller.status().codes.data()).find("G20"), std::string::npos);
}

}  // namespace
}  // namespace kerf::test
