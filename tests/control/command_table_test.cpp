// Every command in every state, as docs/control.md has it.
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

constexpr const char* kLineToHold = "G21 G90\nG1 X1000 F6000\nM2\n";

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
      shop.begin(kLineToHold);
      break;
    case State::waiting:
      shop.give(Command::enable);
      shop.start("G21 G90 F3000\nG1 X1\nM0\nX20\nM2\n");
      shop.tick_until(state);
      break;
    case State::holding:
    case State::held:
      shop.begin(kLineToHold);
      shop.give(Command::hold);
      if (state == State::held) {
        shop.tick_until(state);
      }
      break;
    case State::stopping:
      shop.begin(kLineToHold);
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

}  // namespace
}  // namespace kerf::test
