// A line of an operator that is wrong.
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

TEST(Line, ThatIsWrongIsRefusedAndChangesNothing) {
  Shop shop;
  shop.give(Command::enable);
  shop.run_mdi("G21 G91 G1 X1 F6000");
  for (const char* line : {"G1 X1 F-1", "G55 G77", "G90 X1 Y", "G1 X1\nX2", ""}) {
    const auto given = shop.controller.run_mdi(line);
    ASSERT_FALSE(given) << line;
    EXPECT_EQ(given.error().command, Command::mdi);
    EXPECT_EQ(shop.tick(), State::idle);
  }
  EXPECT_FALSE(shop.controller.program()->diagnostics().empty());
  shop.run_mdi("X1");
  EXPECT_EQ(shop.setpoint.position_mm[0], 2.0);
}

TEST(Line, ThatLeavesTheTravelIsRefused) {
  Shop shop(mill_with_switches());
  shop.give(Command::enable);
  const auto given = shop.controller.run_mdi("G21 G90 G0 X401");
  ASSERT_FALSE(given);
  EXPECT_EQ(given.error().reason, "the line is wrong");
  EXPECT_TRUE(shop.controller.program()->left_travel());
  EXPECT_EQ(shop.tick(100), State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 0.0);
}

// Found with a client: the tool was changed, or the spindle left turning, before the line was found
// wrong after that.
TEST(Line, ThatLeavesTheTravelBehindAWaitOfItsOwnIsRefused) {
  MachineSettings settings = mill_with_switches();
  settings.program.tools.put({.number = 2});
  settings.program.waits_for_spindle = true;
  Controller controller(settings, {.asks_machine = true});
  ASSERT_TRUE(controller.give(Command::enable));
  Setpoint setpoint;
  for (const char* const line : {"T2 M6 G0 X9999", "M3 S1000 G0 X9999", "M60 G0 X9999"}) {
    const auto given = controller.run_mdi(line);
    ASSERT_FALSE(given) << line;
    EXPECT_EQ(given.error().reason, "the line is wrong");
    EXPECT_TRUE(controller.program()->left_travel());
    for (int i = 0; i < 100; ++i) {
      controller.plan();
      EXPECT_EQ(controller.tick(setpoint), State::idle);
    }
    EXPECT_EQ(setpoint.outputs.tool, 0);
    EXPECT_EQ(setpoint.outputs.spindle_rad_s, 0.0);
  }
  EXPECT_TRUE(controller.run_mdi("T2 M6 G0 X99"));
}

// Found with a client: it was told as of line 0 of the program.
TEST(Line, TellsWhereWhatItCallsIsWrong) {
  KernelOptions options;
  options.subprograms = [](std::string_view) {
    return SubprogramText{.file = "deep.ngc",
                          .text = "o<deep> sub\nM0\nG1 X[#7 + \no<deep> endsub\nM2\n"};
  };
  Controller controller(mill(), options);
  ASSERT_TRUE(controller.give(Command::enable));
  ASSERT_TRUE(controller.run_mdi("o<deep> call"));
  Setpoint setpoint;
  for (int i = 0; i < 200; ++i) {
    controller.plan();
    if (controller.tick(setpoint) == State::waiting) {
      ASSERT_TRUE(controller.give(Command::resume));
    }
  }
  controller.plan();
  std::string said;
  for (std::uint32_t number = 1; const auto message = controller.message(number); ++number) {
    said += message->text + "\n";
  }
  EXPECT_TRUE(said.starts_with("deep.ngc:3: ")) << said;
}

}  // namespace
}  // namespace kerf::test
