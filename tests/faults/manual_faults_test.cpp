// Jog, home and what comes between programs: the rows of README.md that are about them.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"

namespace kerf::faults {
namespace {

using test::HomingShop;
using test::Shop;
using test::State;

TEST(ManualFaults, Row64AJogEndsAtTheTravel) {
  HomingShop shop;
  shop.home();
  ASSERT_TRUE(shop.controller.jog({.mm = {1000.0, 0.0, 0.0}, .is_step = true}));
  while (shop.tick() == State::jogging) {
    ASSERT_LE(shop.setpoint.position_mm[0], 400.0);
  }
  EXPECT_EQ(shop.setpoint.position_mm[0], 400.0);
}

TEST(ManualFaults, Row66ASwitchThatIsStuckClosedIsNotTakenForHome) {
  HomingShop shop;
  shop.always_closed = 1U;
  shop.tick(2);  // the second one sees it
  shop.fails_to_home("homing x: its switch stays closed");
  EXPECT_EQ(shop.controller.status().unhomed & 1U, 1U);
}

TEST(ManualFaults, Row66TheSwitchOfAnotherAxisIsNotTakenForHome) {
  HomingShop shop;
  shop.give(Command::home);
  shop.tick(1000);
  shop.always_closed = 2U;  // Z moves, and the wire of Y answers
  shop.tick_until(State::fault);
  EXPECT_EQ(shop.controller.status().unhomed, 7U);
}

// In motion by hand, on the way back, in a search, at a tool change, before anything: nothing moves
// until reset, enable and a command.
TEST(ManualFaults, Row67NothingMovesAfterAnEmergencyStop) {
  const auto hold_and_jog = [](Shop& shop) {
    shop.start("G21 G90 G1 X300 F6000\nM2\n");
    shop.tick(400);
    shop.give(Command::hold);
    shop.tick_until(State::held);
    ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 0.0, 60.0}, .is_step = true}));
    shop.tick(100);
  };
  const std::vector<std::function<void(Shop&)>> stages{
      [](Shop&) {},
      [](Shop& shop) {
        ASSERT_TRUE(shop.controller.jog({.mm = {40.0, 0.0, 0.0}}));
        shop.tick(300);
      },
      [](Shop& shop) {
        shop.give(Command::home);
        shop.tick(300);
      },
      [](Shop& shop) {
        shop.start("G21 G90 G1 X5 F6000\nT2 M6\nX100\nM2\n");
        shop.tick_until(State::waiting);
      },
      hold_and_jog,
      [&](Shop& shop) {
        hold_and_jog(shop);
        shop.tick_until(State::held);
      },
      [&](Shop& shop) {
        hold_and_jog(shop);
        shop.tick_until(State::held);
        shop.give(Command::resume);
        shop.tick(100);
      }};
  MachineSettings settings = test::mill_with_switches();
  settings.manual.unhomed_jog_mm_s = 100.0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    SCOPED_TRACE(i);
    HomingShop shop(settings);
    stages[i](shop);
    shop.controller.emergency_stop();
    shop.tick(500);
    EXPECT_FALSE(shop.controller.drives_on());
    const Position rest_mm = shop.setpoint.position_mm;
    shop.give(Command::reset);
    shop.tick(100);
    EXPECT_FALSE(shop.controller.give(Command::start));
    EXPECT_FALSE(shop.controller.jog({.mm = {1.0, 0.0, 0.0}}));
    shop.give(Command::enable);
    EXPECT_FALSE(shop.controller.give(Command::resume));
    shop.tick(300);
    EXPECT_EQ(shop.setpoint.position_mm, rest_mm);
    EXPECT_EQ(shop.controller.status().state, State::idle);
    shop.start("G21 G91 G1 X1 F600\nM2\n");
    shop.tick_until(State::idle);
    EXPECT_NEAR(shop.setpoint.position_mm[0], rest_mm[0] + 1.0, 1e-9);
  }
}

TEST(ManualFaults, Row73ASwitchIsNotLookedForBeyondItsTravel) {
  HomingShop shop;
  shop.never_closed = 4U;
  shop.fails_to_home("homing z: its switch did not close within 600 mm");
  EXPECT_NEAR(shop.setpoint.position_mm[2], -600.0, 1e-9);
  EXPECT_FALSE(shop.controller.drives_on());
}

// From 400 mm, where the travel ends, to a switch at -105 mm, and 10 mm to back off.
TEST(ManualFaults, Row73ASwitchIsNotLookedForBeyondTheTravelWhereNothingElseIsNamed) {
  MachineSettings settings = test::mill_with_switches();
  settings.manual.homing[2].travel_mm = kUnbounded;
  HomingShop shop(settings);
  shop.never_closed = 4U;
  shop.fails_to_home("homing z: its switch did not close within 515 mm");
}

TEST(ManualFaults, Row73ASwitchIsNotLookedForLongerThanItsTime) {
  MachineSettings settings = test::mill_with_switches();
  settings.manual.homing[2].time_s = 2.0;
  HomingShop shop(settings);
  shop.fails_to_home("homing z: its switch was not found within 2 s");
  EXPECT_LT(std::fabs(shop.setpoint.position_mm[2]), 2.1 * 20.0);
}

}  // namespace
}  // namespace kerf::faults
