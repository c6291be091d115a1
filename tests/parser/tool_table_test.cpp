#include "parser/modal/tool_table.hpp"

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

std::string first_error(std::string_view text) {
  const auto table = read_tool_table(text);
  if (table) {
    return "no error";
  }
  const ToolTableError& error = table.error().front();
  return std::to_string(error.line) + ":" + std::to_string(error.column) + ": " + error.message;
}

TEST(ToolTable, OfNobodyKnowsEveryTool) {
  const ToolTable table;
  ASSERT_NE(table.find(77), nullptr);
  EXPECT_EQ(table.find(77)->diameter_mm, 0.0);
}

TEST(ToolTable, ReadsTheFormOfLinuxCNC) {
  const auto table = read_tool_table(
      "; my tools\r\n"
      "T1 P1 D10 Z+12.5 ;end mill, T9 is not read\r\n"
      "\n"
      "  t20p4z-3 x.5 y-0.25 I10 J90 Q2\n"
      "T3");
  ASSERT_TRUE(table);
  EXPECT_TRUE(table->given());
  ASSERT_EQ(table->listed().size(), 3U);
  EXPECT_EQ(table->find(1)->diameter_mm, 10.0);
  EXPECT_EQ(table->find(1)->offset_mm, (Position{0.0, 0.0, 12.5}));
  EXPECT_EQ(table->find(20)->pocket, 4);
  EXPECT_EQ(table->find(20)->offset_mm, (Position{0.5, -0.25, -3.0}));
  EXPECT_EQ(table->find(20)->front_angle_deg, 10.0);
  EXPECT_EQ(table->find(20)->back_angle_deg, 90.0);
  EXPECT_EQ(table->find(20)->orientation, 2);
  EXPECT_EQ(table->find(3)->pocket, 3);
  EXPECT_EQ(table->find(2), nullptr);
  EXPECT_NE(table->find(0), nullptr) << "the empty spindle";
}

TEST(ToolTable, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(first_error("T1\nP3 Z1"), "2:1: T (tool number) is missing");
  EXPECT_EQ(first_error("T1.5"), "1:1: T: found 1.5, expected a whole number from 0 to 99999");
  EXPECT_EQ(first_error("T-1"), "1:1: T: found -1, expected a whole number from 0 to 99999");
  EXPECT_EQ(first_error("T1 D-3"), "1:4: D (diameter) must not be negative, found -3");
  EXPECT_EQ(first_error("T1 Z"), "1:4: a number is expected after Z");
  EXPECT_EQ(first_error("T1 Z1 Z2"), "1:7: Z is given twice for this tool");
  EXPECT_EQ(first_error("T1 H1"), "1:4: found 'H', expected one of T P D X Y Z I J Q or ';'");
  EXPECT_EQ(first_error("T1 A4"), "1:4: A: tools have offsets along X, Y and Z only");
  EXPECT_EQ(first_error("T1 A0"), "no error");
  EXPECT_EQ(first_error("T1\nT1 Z1"), "2:1: T1 is listed twice");
  EXPECT_EQ(first_error("T1 Z1000000"), "1:4: Z: 1000000 is outside -999999.999..999999.999");
}

TEST(ToolTable, ReportsEveryWrongLine) {
  const auto table = read_tool_table("T1 Z\nT2\nT3 Z\n");
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().size(), 2U);
}

TEST(ToolTable, ReplacesAToolByItsNumber) {
  ToolTable table;
  table.put({.number = 5, .diameter_mm = 1.0});
  table.put({.number = 2, .diameter_mm = 2.0});
  table.put({.number = 5, .diameter_mm = 3.0});
  ASSERT_EQ(table.listed().size(), 2U);
  EXPECT_EQ(table.find(5)->diameter_mm, 3.0);
}

}  // namespace
}  // namespace kerf::parser
