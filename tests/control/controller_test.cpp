// Programs one after the other, what an operator commands meanwhile, and how they end.
#include <algorithm>
#include <optional>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/shop.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

constexpr const char* kLineOf1000 = "G21 G90\nG1 X1000 F6000\nM2\n";

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

// Found by reading: it was that of the first.
TEST(Controller, SaysTheTimeLeftOfTheProgramThatRuns) {
  Controller controller(mill(), {.nominal = NominalTime{.motion_s = 0.2}});
  ASSERT_TRUE(controller.give(Command::enable));
  const auto left_at_begin_s = [&](const std::string& text) {
    EXPECT_TRUE(controller.give(Command::start));
    controller.feed(text);
    controller.finish();
    controller.plan();
    const std::optional<double> left_s = controller.status().left_s;
    Setpoint setpoint;
    for (int i = 0; i < 20'000 && controller.tick(setpoint) != State::idle; ++i) {
      controller.plan();
    }
    return left_s;
  };
  EXPECT_NEAR(left_at_begin_s("G21 G90\nG1 X10 F3000\nM2\n").value_or(0.0), 0.2, 1e-9);
  EXPECT_FALSE(left_at_begin_s("G1 X110 F3000\nM2\n"));
  controller.set_nominal({.motion_s = 2.2, .rest_s = 1.0});
  EXPECT_NEAR(left_at_begin_s("G1 X0 F3000\nG4 P1\nM2\n").value_or(0.0), 3.2, 1e-9);
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

TEST(Controller, WaitsForAnAnswerAtAProgramStop) {
  Shop shop;
  shop.give(Command::enable);
  shop.start("G21 G90 F3000\nG1 X1\nM0\nX20\nM2\n");
  shop.tick_until(State::waiting);
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
  shop.begin(kLineOf1000);
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

// Whoever presses the button after a fault does not switch the drives on.
TEST(Controller, KeepsTheDrivesOffInAnEmergencyStopBehindAFault) {
  Shop shop;
  shop.begin(kLineOf1000);
  shop.controller.fail();
  shop.tick();
  shop.controller.emergency_stop();
  EXPECT_FALSE(shop.controller.drives_on());
  shop.tick(500);
  shop.give(Command::reset);
  shop.begin(kLineOf1000);
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
  shop.begin(kLineOf1000);
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

TEST(Controller, RefusesAnOverrideOutOfItsRange) {
  Shop shop;
  const auto given = shop.controller.set_overrides({.feed = 2.5});
  ASSERT_FALSE(given);
  EXPECT_EQ(given.error().command, Command::override);
  EXPECT_EQ(shop.controller.status().overrides, Overrides{});
}

TEST(Controller, IsStoppedByAThreadOfItsOwn) {
  Shop shop;
  shop.begin(kLineOf1000);
  std::thread button([&] { shop.controller.emergency_stop(); });
  for (int i = 0; i < 5000 && shop.tick() != State::emergency_stop; ++i) {
  }
  button.join();  // however late it was
  while (shop.controller.drives_on()) {
    shop.tick();
  }
  EXPECT_LT(shop.setpoint.position_mm[0], 1000.0);
}

TEST(Controller, RefusesAResumeBehindAStopThatEndsAHold) {
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
