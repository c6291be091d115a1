// One machine, its states and commands, and programs one after the other.
#include <algorithm>
#include <array>
#include <atomic>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

constexpr const char* kLongLine = "G21 G90\nG1 X1000 F6000\nM2\n";

void bring_to(State state, Shop& shop) {
  switch (state) {
    case State::off:
      break;
    case State::emergency_stop:
      shop.controller.emergency_stop();
      break;
    case State::idle:
      shop.give(Command::enable);
      break;
    case State::running:
      shop.begin(kLongLine);
      break;
    case State::waiting:
      shop.give(Command::enable);
      shop.start("G21 G90 F3000\nG1 X1\nM0\nX20\nM2\n");
      shop.tick_until(state);
      break;
    case State::holding:
    case State::held:
      shop.begin(kLongLine);
      shop.give(Command::hold);
      if (state == State::held) {
        shop.tick_until(state);
      }
      break;
    case State::stopping:
      shop.begin(kLongLine);
      shop.give(Command::stop);
      break;
    case State::fault:
      shop.controller.fail();
      break;
    case State::jogging:
      shop.give(Command::enable);
      ASSERT_TRUE(shop.controller.jog({.mm = {10.0, 0.0, 0.0}}));
      break;
    case State::returning:
      bring_to(State::held, shop);
      ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 0.0, 10.0}, .is_step = true}));
      shop.tick_until(State::held);
      shop.give(Command::resume);
      break;
    case State::homing:
      shop.give(Command::enable);
      shop.give(Command::home);
      break;
  }
  shop.tick();
  ASSERT_EQ(shop.controller.status().state, state);
}

// The cells of docs/control.md, by state and command.
std::map<std::string, std::vector<std::string>> documented_table() {
  std::ifstream file(KERF_SOURCE_DIR "/docs/control.md");
  std::map<std::string, std::vector<std::string>> rows;
  std::string line;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    std::stringstream cut(line);
    for (std::string cell; std::getline(cut, cell, '|');) {
      const auto first = cell.find_first_not_of(' ');
      cells.push_back(first == std::string::npos
                          ? ""
                          : cell.substr(first, cell.find_last_not_of(' ') - first + 1));
    }
    if (cells.size() == kCommands + 2) {
      rows[cells[1]] = {cells.begin() + 2, cells.end()};
    }
  }
  return rows;
}

TEST(Controller, AnswersEveryCommandInEveryStateAsDocumented) {
  const auto documented = documented_table();
  ASSERT_EQ(documented.size(), kControllerStates + 2);  // and the head
  for (std::size_t s = 0; s < kControllerStates; ++s) {
    const auto state = static_cast<State>(s);
    for (std::size_t c = 0; c < kCommands; ++c) {
      const auto command = static_cast<Command>(c);
      SCOPED_TRACE(std::string(name_of(state)) + ", " + std::string(name_of(command)));
      const std::string& expected = documented.at(std::string(name_of(state))).at(c);
      EXPECT_EQ(documented.at("state").at(c), name_of(command));
      Shop shop(mill_with_switches());
      bring_to(state, shop);
      ASSERT_FALSE(HasFailure());
      const auto given = command == Command::mdi   ? shop.controller.run_mdi("G21 G0 X1")
                         : command == Command::jog ? shop.controller.jog({.mm = {1.0, 0.0, 0.0}})
                                                   : shop.controller.give(command);
      if (given) {
        EXPECT_EQ(name_of(shop.controller.status().state), expected);
      } else {
        EXPECT_EQ(given.error().reason, expected);
        EXPECT_EQ(given.error().state, state);
        EXPECT_EQ(given.error().command, command);
        EXPECT_EQ(shop.controller.status().state, state);
      }
    }
  }
}

TEST(Controller, RunsASecondProgramLikeTheFirst) {
  const std::string second = "G21 G91\nG1 X30 F3000\nG3 X10 Y10 J10\nM2\n";
  Shop shop;
  shop.begin("G21 G90\nG1 X10 F3000\nM2\n");
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 10.0);
  shop.start(second);
  const auto alone = ticks_of(second, {.start_mm = {10.0, 0.0, 0.0}});
  for (const Setpoint& expected : alone) {
    shop.tick();
    ASSERT_EQ(shop.setpoint.position_mm, expected.position_mm) << expected.tick;
  }
  EXPECT_EQ(shop.controller.status().state, State::idle);
  EXPECT_EQ(shop.controller.status().programs, 2U);
  EXPECT_NEAR(shop.controller.status().run_s, static_cast<double>(alone.size()) * 1e-3, 1e-9);
}

TEST(Controller, HoldsAndGoesOnToTheSameEnd) {
  Shop shop;
  shop.begin(mixed_program());
  shop.give(Command::hold);
  shop.tick_until(State::held);
  EXPECT_EQ(shop.setpoint.v_mm_s, 0.0);
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, ticks_of(mixed_program()).back().position_mm);
}

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

TEST(Controller, WaitsForAnAnswerAtAProgramStop) {
  Shop shop;
  bring_to(State::waiting, shop);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::answer);
  EXPECT_EQ(shop.setpoint.position_mm[0], 1.0);
  shop.tick(100);
  EXPECT_EQ(shop.setpoint.position_mm[0], 1.0);
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 20.0);
}

TEST(Controller, MovesNothingAfterAnEmergencyStopUntilResetEnableAndStart) {
  Shop shop;
  shop.begin(kLongLine);
  shop.controller.emergency_stop();
  EXPECT_TRUE(shop.controller.drives_on());
  const auto too_early = shop.controller.give(Command::reset);
  ASSERT_FALSE(too_early);
  EXPECT_EQ(too_early.error().reason, "the tool still moves");
  while (shop.controller.drives_on()) {
    shop.tick();
  }
  const Position at = shop.setpoint.position_mm;
  shop.give(Command::reset);
  shop.tick(100);
  shop.give(Command::enable);
  shop.tick(100);
  EXPECT_EQ(shop.setpoint.position_mm, at);
  shop.start("G21 G90\nG1 X0 F6000\nM2\n");
  shop.tick();
  EXPECT_NEAR(shop.setpoint.position_mm[0], at[0], 1e-3);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
}

// Whoever presses the button behind a fault does not switch the drives on.
TEST(Controller, KeepsTheDrivesOffInAnEmergencyStopBehindAFault) {
  Shop shop;
  shop.begin(kLongLine);
  shop.controller.fail();
  shop.tick();
  shop.controller.emergency_stop();
  EXPECT_FALSE(shop.controller.drives_on());
  shop.tick(500);
  shop.give(Command::reset);
  shop.begin(kLongLine);
  EXPECT_TRUE(shop.controller.drives_on());
  shop.controller.emergency_stop();
  EXPECT_TRUE(shop.controller.drives_on());  // it brakes
}

TEST(Controller, IsIdleAfterAProgramWithAnErrorAndHasIt) {
  Shop shop;
  shop.begin("G21 G90\nG1 X1 F3000\nX2 F-1\nM2\n");
  shop.tick_until(State::idle);
  ASSERT_NE(shop.controller.program(), nullptr);
  EXPECT_TRUE(shop.controller.program()->has_errors());
}

// On this line X is the path length, of one tick or of another, never of two.
TEST(Controller, ShowsEachThreadAWholeTick) {
  Shop shop;
  shop.begin(kLongLine);
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

TEST(Controller, HasOverridesAndSingleBlockForAllPrograms) {
  Shop shop;
  const auto fastest = [&shop](int ticks) {
    double most = 0.0;
    for (int i = 0; i < ticks; ++i) {
      shop.tick();
      most = std::max(most, shop.setpoint.v_mm_s);
    }
    return most;
  };
  shop.begin(kLongLine);
  ASSERT_TRUE(shop.controller.set_overrides({.feed = 0.5}));
  shop.tick(200);
  EXPECT_NEAR(fastest(200), 50.0, 0.05);
  EXPECT_EQ(shop.controller.status().overrides, (Overrides{.feed = 0.5}));
  shop.give(Command::stop);
  shop.tick_until(State::idle);
  ASSERT_TRUE(shop.controller.set_single_block(true));
  EXPECT_TRUE(shop.controller.status().single_block);
  shop.start("G21 G91 F6000\nG1 X20\nX-20\nM2\n");
  EXPECT_NEAR(fastest(700), 50.0, 0.05);
  EXPECT_EQ(shop.controller.status().state, State::waiting);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::answer);
}

TEST(Controller, HasOptionalStopsAndBlockDeleteForTextThatIsNotReadYet) {
  Shop shop;
  shop.give(Command::enable);
  shop.give(Command::start);
  shop.controller.feed("G21 G90 F6000\nG1 X100\n");
  shop.tick(100);
  BlockDelete second;
  second.switch_on(2);
  ASSERT_TRUE(shop.controller.set_optional_stop(true));
  ASSERT_TRUE(shop.controller.set_block_delete(second));
  EXPECT_TRUE(shop.controller.status().optional_stop);
  EXPECT_EQ(shop.controller.status().block_delete, second);
  shop.controller.feed("/2 X200\n/3 X120\nM1\nX130\nM2\n");
  shop.controller.finish();
  for (int i = 0; i < 5000 && shop.controller.status().waits_for != WaitsFor::answer; ++i) {
    shop.tick();
  }
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::answer);
  EXPECT_EQ(shop.setpoint.position_mm[0], 120.0);
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  shop.start("G21 G90 G0 X0\n/2 X50\nM1\nM2\n");
  shop.tick_until(State::waiting);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
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
  EXPECT_EQ(told, (std::vector<std::string>{"idle", "running", "waiting", "tool 2", "running",
                                            "at 50.000000", "holding", "held", "running", "idle"}));
  EXPECT_EQ(events[2].waits_for, WaitsFor::answer);
  EXPECT_EQ(events[2].line, 4);
  EXPECT_EQ(shop.controller.status().next_event, count + 1);
}

TEST(Controller, ShowsTheCodesInForceWhereTheToolIs) {
  Shop shop;
  shop.begin("G21 G90 G61\nG1 X100 F6000\nG20 G1 X5\nM2\n");
  EXPECT_NE(std::string(shop.controller.status().codes.data()).find("G21"), std::string::npos);
  shop.tick(1000);
  EXPECT_NE(std::string(shop.controller.status().codes.data()).find("G20"), std::string::npos);
}

TEST(Controller, RefusesAnOverrideOutOfItsRange) {
  Shop shop;
  const auto given = shop.controller.set_overrides({.feed = 2.5});
  ASSERT_FALSE(given);
  EXPECT_EQ(given.error().command, Command::override);
  EXPECT_EQ(shop.controller.status().overrides, Overrides{});
}

TEST(Controller, IsStoppedByAThreadOfItsOwn) {
  Shop shop;
  shop.begin(kLongLine);
  std::thread button([&] { shop.controller.emergency_stop(); });
  for (int i = 0; i < 5000 && shop.tick() != State::emergency_stop; ++i) {
  }
  button.join();  // however late it was
  while (shop.controller.drives_on()) {
    shop.tick();
  }
  EXPECT_LT(shop.setpoint.position_mm[0], 1000.0);
}

// By its number in the list of faults, as in tests/kernel/faults_test.cpp.
TEST(Fault55, AResumeBehindAnAbortIsRefused) {
  const auto tick = [](Controller& controller, int count) {
    Setpoint setpoint;
    for (int i = 0; i < count; ++i) {
      controller.plan();
      controller.tick(setpoint);
    }
    return setpoint.position_mm;
  };
  for (const bool held : {false, true}) {
    Controller controller(mill());
    ASSERT_TRUE(controller.give(Command::enable));
    ASSERT_TRUE(controller.give(Command::start));
    controller.feed("G21 G90\nG1 X500 F6000\nM2\n");
    controller.finish();
    tick(controller, 500);
    ASSERT_TRUE(controller.give(Command::hold));
    tick(controller, held ? 400 : 20);
    ASSERT_TRUE(controller.give(Command::stop));
    EXPECT_FALSE(controller.give(Command::resume));
    const Position rest_mm = tick(controller, 400);
    EXPECT_EQ(controller.status().state, ControllerState::idle);
    EXPECT_FALSE(controller.give(Command::resume));
    EXPECT_EQ(tick(controller, 200), rest_mm);
  }
}

}  // namespace
}  // namespace kerf::test
