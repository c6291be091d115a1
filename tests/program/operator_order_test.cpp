#include "programs/kerf/control/operator_order.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

constexpr double kThird = 1.0 / 3.0;  // no decimal fraction

template <typename T>
T again(const T& order) {
  const auto read = order_from(text_of(order));
  EXPECT_TRUE(read && std::holds_alternative<T>(*read)) << text_of(order);
  return read && std::holds_alternative<T>(*read) ? std::get<T>(*read) : T{};
}

TEST(OperatorOrder, OfEachKindComesBackToTheLastBit) {
  EXPECT_EQ(again(kerf::Command::resume), kerf::Command::resume);
  const Overrides overrides{.feed = kThird, .rapid = 0.1, .spindle = 1.0 + kThird};
  EXPECT_EQ(again(overrides), overrides);
  EXPECT_TRUE(again(SingleBlock{.is_on = true}).is_on);
  EXPECT_FALSE(again(OptionalStop{.is_on = false}).is_on);
  BlockDelete switches;
  switches.switch_on(1);
  switches.switch_on(9);
  EXPECT_EQ(again(switches), switches);
  const FeedInputs inputs{.adaptive = kThird, .stop = true};
  EXPECT_EQ(again(inputs), inputs);
  const Jog step{.mm = {kThird, -1e-9, 0.0}, .extra_rad_mm = {0.0, 1e300}, .is_step = true};
  EXPECT_EQ(again(step), step);
  const Jog slow{.mm = {1.0}, .is_step = true, .step_mm_s = kThird};
  EXPECT_EQ(again(slow), slow);
  EXPECT_EQ(again(MdiLine{.text = "G1 X1 (\"a\\b\")"}).text, "G1 X1 (\"a\\b\")");
}

TEST(OperatorOrder, OfAToolHasAllOfIt) {
  const Tool tool{.number = 7,
                  .pocket = 3,
                  .offset_mm = {1.0, kThird, -2.0},
                  .diameter_mm = 6.5,
                  .front_angle_deg = 1.5,
                  .back_angle_deg = 2.5,
                  .orientation = 4,
                  .length_wear_mm = 0.01,
                  .radius_wear_mm = 0.02};
  const Tool read = again(tool);
  EXPECT_EQ(read.number, tool.number);
  EXPECT_EQ(read.pocket, tool.pocket);
  EXPECT_EQ(read.offset_mm, tool.offset_mm);
  EXPECT_EQ(read.diameter_mm, tool.diameter_mm);
  EXPECT_EQ(read.front_angle_deg, tool.front_angle_deg);
  EXPECT_EQ(read.back_angle_deg, tool.back_angle_deg);
  EXPECT_EQ(read.orientation, tool.orientation);
  EXPECT_EQ(read.length_wear_mm, tool.length_wear_mm);
  EXPECT_EQ(read.radius_wear_mm, tool.radius_wear_mm);
}

TEST(OperatorOrder, OfAnotherTextIsNone) {
  for (const char* text :
       {"", "hold", "{}", "[]", "[1]", "[\"hold\"]", "[\"command\"]", "[\"command\", 99]",
        "[\"command\", -1]", "[\"override\", 1, 1]", "[\"override\", \"1\", 1, 1]", "[\"mdi\", 1]",
        "[\"jog\", [1], [], 0]"}) {
    EXPECT_FALSE(order_from(text)) << text;
  }
}

}  // namespace
}  // namespace kerf::program
