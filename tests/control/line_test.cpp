// One line of an operator, with what programs and lines have left in force.
#include <array>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

struct LineShop : Shop {
  LineShop() { give(Command::enable); }
  [[nodiscard]] std::string codes() {
    tick();
    return {controller.status().codes.data()};
  }
};

TEST(Line, MovesWithTheCodesOfTheLinesBefore) {
  LineShop shop;
  shop.run_mdi("G21 G91 G1 X10 F6000");
  shop.run_mdi("X10");
  EXPECT_EQ(shop.setpoint.position_mm[0], 20.0);
  shop.run_mdi("G20 G90 Y1");
  EXPECT_EQ(shop.setpoint.position_mm[1], 25.4);
  EXPECT_EQ(shop.setpoint.position_mm[0], 20.0);
}

TEST(Line, HasParametersOffsetsAndToolsOfTheProgramBefore) {
  LineShop shop;
  shop.start("G21 G90\n#101 = 7\n#<_wide> = 3\nG10 L2 P2 X100 Y50\nG1 X1 F6000\nM2\n");
  shop.tick_until(State::idle);
  shop.run_mdi("G55 G0 X[#101] Y#<_wide>");
  EXPECT_EQ(shop.setpoint.position_mm[0], 107.0);
  EXPECT_EQ(shop.setpoint.position_mm[1], 53.0);
}

// As LinuxCNC has it of M2: G54, G17, G90, G94, G40, M48, M5, M9, G1; F, units and G92 stay.
TEST(Line, BeginsBehindAProgramsEndWhereThatLeavesIt) {
  LineShop shop;
  shop.start("G20 G91 G18 G55 G95 M3 S600 M8\nG1 X0.1 F0.1\nM2\n");
  shop.tick_until(State::idle);
  shop.run_mdi("G4 P0.01");
  const std::string codes = shop.codes();
  for (const char* code : {"G1 ", "G17", "G20", "G90", "G94", "G40", "G54", "M5", "M9"}) {
    EXPECT_NE(codes.find(code), std::string::npos) << code << " in " << codes;
  }
}

// Found with a client: after a line without motion no code was shown.
TEST(Line, ShowsWhatIsInForceThoughNothingMoved) {
  LineShop shop;
  shop.run_mdi("G21 G90 G0 X5");
  for (const auto& [line, code] : {std::pair{"G55", "G55"},
                                   {"G91", "G91"},
                                   {"G20", "G20"},
                                   {"M3 S600 M8", "M3"},
                                   {"(MSG,hello)", "G91"},
                                   {"M2", "M5"},
                                   {"G64 P0.1", "G90"}}) {
    shop.run_mdi(line);
    const std::string codes = shop.codes();
    EXPECT_NE((" " + codes + " ").find(" " + std::string(code) + " "), std::string::npos)
        << line << ": " << codes;
  }
  ASSERT_TRUE(shop.controller.run_mdi("T1 M6"));
  shop.tick_until(State::waiting);
  EXPECT_NE(shop.codes().find("G90"), std::string::npos) << "nothing has come to its block yet";
}

// A sender may not know yet that its program was stopped.
TEST(Line, IsNotGoneOnWithByTextOfAProgramThatIsOver) {
  LineShop shop;
  ASSERT_TRUE(shop.controller.run_mdi("M0"));
  shop.tick_until(State::waiting);
  shop.controller.feed("G1 X40 F6000\n");
  shop.controller.finish();
  shop.give(Command::resume);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
}

TEST(Line, WaitsForNoTextWhereAProgramBeforeItDid) {
  LineShop shop;
  shop.give(Command::start);
  shop.controller.feed("G21 G90 G1 X1 F6000\n");
  for (int i = 0; i < 1000; ++i) {
    shop.tick();
    if (shop.controller.status().waits_for == WaitsFor::text) {
      shop.controller.text_is_late();
    }
  }
  shop.give(Command::stop);
  shop.tick_until(State::idle);
  ASSERT_TRUE(shop.controller.set_overrides({.feed = 0.0}));
  ASSERT_TRUE(shop.controller.run_mdi("G1 X5 F600"));
  EXPECT_EQ(shop.tick(100), State::running);
  EXPECT_EQ(shop.controller.status().waits_for, WaitsFor::nothing);
}

TEST(Line, KeepsSpindleCoolantAndOutputsOn) {
  LineShop shop;
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  shop.run_mdi("M3 S600 M8");
  shop.run_mdi("M64 P3");
  shop.run_mdi("G21 G1 X5 F3000");
  constexpr double kHalf_rad_s = 0.5 * 600.0 * 2.0 * 3.14159265358979323846 / 60.0;
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, kHalf_rad_s, 1e-9);
  EXPECT_TRUE(shop.setpoint.outputs.flood);
  EXPECT_EQ(shop.setpoint.outputs.digital, 1U << 3U);
  shop.run_mdi("M5 M9");
  EXPECT_EQ(shop.setpoint.outputs.spindle_rad_s, 0.0);
  EXPECT_FALSE(shop.setpoint.outputs.flood);
}

// Found with a client: a line without motion had no tick that it could have counted for.
TEST(Line, FollowsOverridesAndInputsAsTheLineBeforeAllows) {
  LineShop shop;
  shop.run_mdi("G21 M52 P1");
  ASSERT_TRUE(shop.controller.set_feed_inputs({.adaptive = 0.0}));
  ASSERT_TRUE(shop.controller.run_mdi("G1 X20 F6000"));
  shop.tick(1000);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
  ASSERT_TRUE(shop.controller.set_feed_inputs({.adaptive = 1.0}));
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 20.0);

  shop.run_mdi("M52 P0");
  shop.run_mdi("M53 P0");
  ASSERT_TRUE(shop.controller.set_feed_inputs({.adaptive = 0.0, .stop = true}));
  shop.run_mdi("G1 X30");
  EXPECT_EQ(shop.setpoint.position_mm[0], 30.0);

  shop.run_mdi("M3 S1000");
  shop.run_mdi("M51 P0");
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  shop.run_mdi("G1 X40");
  constexpr double kProgrammed_rad_s = 1000.0 * 2.0 * 3.14159265358979323846 / 60.0;
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, kProgrammed_rad_s, 1e-9);
}

// Found by reading: the hole after M2 was taken for one more of the series before it, and the tool
// went back to the height of that.
TEST(Line, ACycleBehindAnEndOfTheProgramGoesBackToWhereItBegan) {
  LineShop shop;
  shop.run_mdi("G21 G90 G0 Z20");
  shop.run_mdi("G98 G81 X0 Y0 Z-5 R2 F6000");
  shop.run_mdi("M2");
  shop.run_mdi("Z60");
  shop.run_mdi("G98 G81 X10 Y0 Z-5 R2");
  EXPECT_EQ(shop.setpoint.position_mm[2], 60.0);
}

TEST(Line, TurnsTheSpindleAsWasProgrammedWhenTheOverrideHasChanged) {
  LineShop shop;
  constexpr double kWhole_rad_s = 600.0 * 2.0 * 3.14159265358979323846 / 60.0;
  shop.run_mdi("M3 S600");
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  EXPECT_FALSE(shop.controller.run_mdi("G1 Y"));  // what is refused changes nothing
  shop.run_mdi("G21 G1 X5 F3000");
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, 0.5 * kWhole_rad_s, 1e-9);
  ASSERT_TRUE(shop.controller.set_overrides({}));
  shop.run_mdi("X0");
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, kWhole_rad_s, 1e-9);
  ASSERT_TRUE(shop.controller.run_mdi("X9"));
  shop.tick(20);
  shop.give(Command::hold);
  shop.tick_until(State::held);
  ASSERT_TRUE(shop.controller.jog({.mm = {0.0, 1.0, 0.0}, .is_step = true}));
  shop.tick_until(State::held);
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  shop.give(Command::stop);
  shop.run_mdi("X3");
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, 0.5 * kWhole_rad_s, 1e-9);
}

// Found with a client: it was accepted and shown, and the spindle followed it with the next line.
TEST(Line, LeavesASpindleThatFollowsItsOverride) {
  LineShop shop;
  constexpr double kWhole_rad_s = 600.0 * 2.0 * 3.14159265358979323846 / 60.0;
  const auto expect_share = [&](double share) {
    shop.tick(3);
    EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, share * kWhole_rad_s, 1e-9);
  };
  shop.run_mdi("M3 S600");
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  expect_share(0.5);
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.1}));
  shop.controller.plan();
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 2.0}));
  shop.controller.plan();
  expect_share(2.0);
  shop.run_mdi("G21 G1 X5 F3000");
  expect_share(2.0);
  ASSERT_TRUE(shop.controller.set_overrides({}));
  expect_share(1.0);
}

// Found with a client: what comes with the next motion came with the next line.
TEST(Line, AllowsTheOverrideOfTheSpindleOrNotByItself) {
  LineShop shop;
  constexpr double kWhole_rad_s = 600.0 * 2.0 * 3.14159265358979323846 / 60.0;
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.5}));
  shop.run_mdi("M3 S600");
  for (const auto& [line, share] : {std::pair{"M49", 1.0}, {"M48", 0.5}, {"M51 P0 M8", 1.0}}) {
    shop.run_mdi(line);
    EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, share * kWhole_rad_s, 1e-9) << line;
  }
  ASSERT_TRUE(shop.controller.set_overrides({.spindle = 0.2}));  // not followed
  shop.tick(3);
  EXPECT_NEAR(shop.setpoint.outputs.spindle_rad_s, kWhole_rad_s, 1e-9);
}

// They end before the planning thread looks again.
TEST(Line, SaysWhatItHasToSayHoweverShortItIs) {
  LineShop shop;
  for (const char* line : {"M5 (MSG, one)", "M9 (MSG, two)"}) {
    ASSERT_TRUE(shop.controller.run_mdi(line));
    for (State state = State::running; state != State::idle;) {
      state = shop.controller.tick(shop.setpoint);
    }
  }
  shop.controller.plan();
  std::array<ControllerEvent, 16> events;
  const std::size_t count = shop.controller.events_since(1, events);
  std::string told;
  for (std::size_t i = 0; i < count; ++i) {
    const auto message = shop.controller.message(events[i].message);
    told += message ? message->text + ";" : "";
    // Of no line of the program, which it is none of.
    EXPECT_EQ(message ? message->line : 0U, 0U);
  }
  EXPECT_EQ(told, "one;two;");
}

TEST(Line, MayBeAMessageAlone) {
  LineShop shop;
  shop.run_mdi("(MSG, the vice is at the left)");
  EXPECT_EQ(shop.told(), "the vice is at the left");
  EXPECT_FALSE(shop.controller.run_mdi("(nobody hears this)"));
}

TEST(Line, HasTheToolThatWasSetBehindTheLineBefore) {
  LineShop shop;
  shop.run_mdi("G21 G90 G0 X1");
  ASSERT_TRUE(shop.controller.set_tool({.number = 2, .pocket = 2, .offset_mm = {0.0, 0.0, 7.0}}));
  shop.run_mdi("G43 H2 G0 Z1");
  EXPECT_EQ(shop.setpoint.position_mm[2], 8.0);
}

TEST(Line, HasTheToolThatWasSetBehindALineThatWasRefused) {
  LineShop shop;
  shop.run_mdi("G21 G90 G0 X1");
  EXPECT_FALSE(shop.controller.run_mdi("G1 Y"));
  ASSERT_TRUE(shop.controller.set_tool({.number = 2, .pocket = 2, .offset_mm = {0.0, 0.0, 7.0}}));
  shop.run_mdi("G43 H2 G0 Z1");
  EXPECT_EQ(shop.setpoint.position_mm[2], 8.0);
}

TEST(Line, LeavesWhatIsInForceToTheNextProgram) {
  LineShop shop;
  shop.run_mdi("G10 L2 P1 X30");
  shop.start("G21 G90 G0 X1\nM2\n");
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 31.0);
  shop.start("G21 G90 G0 X1\nM2\n");  // after a program a program begins afresh
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 1.0);
}

TEST(Line, HasTheCodesOfThePlaceWhereAProgramWasStopped) {
  LineShop shop;
  shop.start("G21 G90 G54 G61\nG1 X500 F6000\nG10 L2 P2 X7\nG55 G91 G1 X1\nM2\n");
  shop.tick(500);
  shop.give(Command::stop);
  shop.tick_until(State::idle);
  const double at_mm = shop.setpoint.position_mm[0];
  ASSERT_LT(at_mm, 400.0);
  shop.run_mdi("G0 X450");
  EXPECT_EQ(shop.setpoint.position_mm[0], 450.0);  // neither G91 nor G55 was reached
}

TEST(Line, IsHeldAndStoppedAsAProgram) {
  LineShop shop;
  ASSERT_TRUE(shop.controller.run_mdi("G21 G1 X200 F6000"));
  shop.tick(300);
  shop.give(Command::hold);
  shop.tick_until(State::held);
  shop.give(Command::resume);
  shop.tick(100);
  shop.give(Command::stop);
  shop.tick_until(State::idle);
  EXPECT_LT(shop.setpoint.position_mm[0], 200.0);
  EXPECT_EQ(shop.controller.status().programs, 0U);
}

}  // namespace
}  // namespace kerf::test
