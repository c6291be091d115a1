// The parameters that show the machine's state. The values wanted were read with rs274's (DEBUG,),
// whose machine counts in inch.
#include "parser/offsets/machine_values.hpp"

#include <gtest/gtest.h>

#include "parser/block/block_grammar.hpp"
#include "parser/interpreter/interpreter.hpp"

namespace kerf::parser {
namespace {

// An interpreter that has run some blocks.
class MachineValuesOf : public testing::Test {
 protected:
  void run(std::initializer_list<std::string_view> blocks) {
    for (const std::string_view text : blocks) {
      BlockWords block;
      const bool complete = read_block(text, block, evaluator_);
      interpreter_.run(block, ++line_, complete);
    }
    EXPECT_TRUE(diagnostics_.all().empty()) << diagnostics_.all().front().message;
  }
  double value(int number) { return values_.number(number).value_or(-999.0); }
  double value(std::string_view name) { return values_.name(name).value_or(-999.0); }

  diagnostics::DiagnosticList diagnostics_{10};
  std::uint32_t line_ = 0;
  Parameters parameters_;
  Evaluator evaluator_{parameters_};
  Interpreter interpreter_{{.machine = default_program_data()}, diagnostics_};
  MachineValues values_{interpreter_.memory()};
};

TEST_F(MachineValuesOf, TheStartAreThoseOfLinuxCNC) {
  const std::initializer_list<std::pair<std::string_view, double>> wanted{
      {"_vmajor", 2.9},
      {"_motion_mode", 800.0},
      {"_plane", 170.0},
      {"_metric", 1.0},
      {"_imperial", 0.0},
      {"_absolute", 1.0},
      {"_incremental", 0.0},
      {"_inverse_time", 0.0},
      {"_units_per_minute", 1.0},
      {"_units_per_rev", 0.0},
      {"_coord_system", 540.0},
      {"_tool_offset", 0.0},
      {"_spindle_rpm_mode", 1.0},
      {"_spindle_css_mode", 0.0},
      {"_ijk_absolute_mode", 0.0},
      {"_spindle_on", 0.0},
      {"_mist", 0.0},
      {"_speed_override", 1.0},
      {"_feed_override", 1.0},
      {"_adaptive_feed", 0.0},
      {"_feed_hold", 1.0},
      {"_feed", 0.0},
      {"_rpm", 0.0},
      {"_x", 0.0},
      {"_w", 0.0},
      {"_abs_z", 0.0},
      {"_current_tool", 0.0},
      {"_selected_pocket", -1.0},
      {"_call_level", 0.0},
      {"_lathe_radius_mode", 1.0}};
  for (const auto& [name, number] : wanted) {
    EXPECT_EQ(value(name), number) << name;
  }
  EXPECT_FALSE(values_.name("_nothing"));
  EXPECT_FALSE(values_.name("x"));
  EXPECT_FALSE(values_.number(31));
}

TEST_F(MachineValuesOf, EveryModeFollowsItsCode) {
  run({"T2", "M6", "T3", "G95 G96 S100 D500", "F0.5", "M4 M7", "M8", "M49", "M53 P0", "G91",
       "G90.1", "G18", "G59.2", "G43 H1", "M52 P1", "G0 X25.4 Z12.7", "G20"});
  const std::initializer_list<std::pair<std::string_view, double>> wanted{
      {"_motion_mode", 0.0},
      {"_plane", 180.0},
      {"_metric", 0.0},
      {"_absolute", 0.0},
      {"_units_per_rev", 1.0},
      {"_coord_system", 592.0},
      {"_tool_offset", 1.0},
      {"_spindle_css_mode", 1.0},
      {"_ijk_absolute_mode", 1.0},
      {"_spindle_on", 1.0},
      {"_spindle_cw", 0.0},
      {"_mist", 1.0},
      {"_flood", 1.0},
      {"_speed_override", 0.0},
      {"_feed_override", 0.0},
      {"_adaptive_feed", 1.0},
      {"_feed_hold", 0.0},
      {"_feed", 0.5},
      {"_rpm", 100.0},
      {"_x", 1.0},
      {"_abs_x", 1.0},
      {"_abs_z", 0.5},
      {"_current_tool", 2.0},
      {"_selected_tool", 3.0},
      {"_selected_pocket", 3.0},
      {"_line", 17.0}};
  for (const auto& [name, number] : wanted) {
    EXPECT_DOUBLE_EQ(value(name), number) << name;
  }
  EXPECT_DOUBLE_EQ(value("_z"), (12.7 - 12.5) / 25.4);
}

TEST_F(MachineValuesOf, OffsetsAreInMillimetresAndPositionsInTheProgramsUnits) {
  run({"G92 X10", "G20 F10 G1 X1"});
  EXPECT_EQ(value(5211), -10.0);
  EXPECT_EQ(value(5210), 1.0);
  EXPECT_DOUBLE_EQ(value(5420), 1.0);
  EXPECT_DOUBLE_EQ(value("_abs_x"), 15.4 / 25.4);
  run({"G21", "G28.1", "G92.2", "G10 L2 P3 X5 R30", "T1 M6"});
  EXPECT_DOUBLE_EQ(value(5161), 15.4);
  EXPECT_EQ(value(5210), 0.0);
  EXPECT_EQ(value(5211), -10.0) << "kept for G92.3";
  EXPECT_EQ(value(5220), 1.0);
  EXPECT_EQ(value(5261), 5.0);
  EXPECT_EQ(value(5270), 30.0);
  EXPECT_EQ(value(5400), 1.0);
  EXPECT_EQ(value(5403), 12.5);
  EXPECT_EQ(value(5410), 10.0);
}

TEST_F(MachineValuesOf, WrittenOffsetsWaitUntilTheyAreChosen) {
  EXPECT_TRUE(values_.take(5221, 1.0));
  run({"G0 X1", "G54 X2"});
  EXPECT_EQ(value("_abs_x"), 2.0);
  run({"G55", "G54 X2"});
  EXPECT_EQ(value("_abs_x"), 3.0);
  EXPECT_TRUE(values_.take(5211, 4.0));
  EXPECT_EQ(value(5420), 2.0);
  run({"G92.3"});
  EXPECT_EQ(value(5420), -2.0);
  EXPECT_TRUE(values_.take(5182, 7.0));
  run({"G30 Y0"});
  EXPECT_EQ(value("_abs_y"), 7.0);
  EXPECT_FALSE(values_.take(5224, 1.0)) << "a mill has no axis A";
  EXPECT_FALSE(values_.take(100, 1.0));
}

TEST_F(MachineValuesOf, AWaitInVainLeavesMinusOne) {
  run({"M66 P0 L0"});
  EXPECT_EQ(value(5399), 0.0);
  run({"M66 P0 L3 Q2"});
  EXPECT_EQ(value(5399), -1.0);
}

TEST(FanucVariables, ShowOffsetsPositionsAndModes) {
  diagnostics::DiagnosticList diagnostics(10);
  Interpreter interpreter({.machine = default_program_data(), .dialect = Dialect::fanuc},
                          diagnostics);
  Parameters parameters(Dialect::fanuc);
  Evaluator evaluator(parameters);
  std::uint32_t line = 0;
  const auto run = [&](std::string_view text) {
    BlockWords block;
    const bool complete = read_block(text, block, evaluator);
    interpreter.run(block, ++line, complete);
  };
  for (const std::string_view text :
       {"G10 L2 P2 X5 Y6", "G55 G43 H1", "F100 S500 T3", "G10 L20 P3 Z9", "G1 X1 Y2 Z3"}) {
    run(text);
  }
  EXPECT_TRUE(diagnostics.all().empty());
  MachineValues values(interpreter.memory());
  const std::initializer_list<std::pair<int, double>> wanted{
      {5241, 5.0},  {5242, 6.0},   {5221, 0.0},   {7043, 9.0},  {5001, 1.0},   {5042, 2.0},
      {5021, 6.0},  {5023, 15.5},  {5083, 12.5},  {2001, 12.5}, {11001, 12.5}, {13001, 5.0},
      {10001, 0.0}, {13099, 0.0},  {4001, 1.0},   {4003, 90.0}, {4006, 21.0},  {4014, 55.0},
      {4008, 43.0}, {4109, 100.0}, {4119, 500.0}, {4120, 3.0}};
  for (const auto& [number, value] : wanted) {
    EXPECT_EQ(values.number(number).value_or(-999.0), value) << number;
  }
  EXPECT_FALSE(values.number(5004));
  EXPECT_FALSE(values.number(5420));
  EXPECT_TRUE(values.take(5241, 10.0));
  EXPECT_EQ(values.number(5001), -4.0) << "at once";
  EXPECT_TRUE(values.take(11002, 33.0));
  run("G43 H2");
  EXPECT_EQ(values.number(5083), 33.0);
  run("G44 H2");
  EXPECT_EQ(values.number(5083), -33.0);
  EXPECT_FALSE(values.take(5021, 1.0));
}

}  // namespace
}  // namespace kerf::parser
