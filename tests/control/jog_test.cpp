// Motion by hand: steps and continuous jogs.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/control/jog_shop.hpp"

namespace kerf::test {
namespace {

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

// It was possible when it was asked for, as the one before it had not come to the travel's end yet.
TEST(Jog, ThatIsNotPossibleOnceItsTurnComesIsSaidToBeLeftOut) {
  JogShop shop;
  shop.jog({.mm = {400.0, 0.0, 0.0}, .is_step = true});
  EXPECT_EQ(shop.go(300), State::jogging);
  shop.jog({.mm = {10.0, 0.0, 0.0}, .is_step = true, .step_mm_s = 5.0});
  shop.go_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 400.0);
  EXPECT_EQ(shop.told(),
            "the jog that was to follow is left out: an axis is at the end of its travel");
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

// Found with a client: it began ten seconds after the key was let go.
TEST(Jog, DoesNotBeginBehindAnotherWhereItWasNotGivenAgain) {
  Shop shop;
  shop.give(Command::enable);
  ASSERT_TRUE(shop.controller.jog({.mm = {50.0}, .is_step = true, .step_mm_s = 20.0}));
  shop.tick(5);
  ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 50.0}}));
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm, (Position{50.0, 0.0, 0.0}));
  EXPECT_EQ(shop.told(), "the jog that was to follow is left out: it was not given again");
}

TEST(Jog, BeginsBehindAnotherAsLongAsItIsGivenAgain) {
  Shop shop;
  shop.give(Command::enable);
  ASSERT_TRUE(shop.controller.jog({.mm = {10.0}, .is_step = true, .step_mm_s = 20.0}));
  for (int i = 0; i < 10; ++i) {
    ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 50.0}}));
    shop.tick(100);
  }
  EXPECT_GT(shop.setpoint.position_mm[1], 5.0);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 10.0);
}

// Found with a client: the one before ran out of time while it came to rest for this one.
TEST(Jog, BeginsBehindAContinuousOneWheneverThatWasGivenLast) {
  for (int after = 400; after <= 500; after += 10) {
    Shop shop;
    shop.give(Command::enable);
    ASSERT_TRUE(shop.controller.jog({.mm = {50.0}}));
    shop.tick(after);
    ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 5.0}, .is_step = true, .step_mm_s = 50.0}));
    shop.tick_until(State::idle);
    EXPECT_EQ(shop.setpoint.position_mm[1], 5.0) << after;
  }
}

TEST(Jog, AddsUpStepsOfAnySpeed) {
  Shop shop;
  shop.give(Command::enable);
  const auto step = [&](double mm, double mm_s) {
    ASSERT_TRUE(shop.controller.jog({.mm = {mm}, .is_step = true, .step_mm_s = mm_s}));
  };
  step(10.0, 50.0);
  step(10.0, 20.0);
  step(10.0, 30.0);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 30.0);
  step(1.0, 50.0);
  step(5.0, 50.0);
  step(-5.0, 50.0);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 31.0);
  EXPECT_EQ(shop.told(), "") << "there is nothing to say";
}

}  // namespace
}  // namespace kerf::test
