#include <gtest/gtest.h>

#include "parser/modal/touch_box.hpp"
#include "tests/parser/program.hpp"

namespace kerf::parser {
namespace {

ReaderOptions with_box(const TouchBox& box) {
  ReaderOptions options;
  options.machine.touch_box = box;
  return options;
}

// The top at Z2, the sides at X10 and X20, open to the other sides.
TouchBox block() {
  TouchBox box;
  box.max_mm[2] = 2.0;
  box.min_mm[0] = 10.0;
  box.max_mm[0] = 20.0;
  return box;
}

std::vector<std::string> steps_of(const std::string& text) {
  const Program program = read_program(text + "\nM2\n", with_box(block()));
  std::vector<std::string> steps;
  for (const Move& move : program.moves) {
    steps.push_back(text_of(move));
  }
  if (program.has_errors) {
    steps.push_back(to_string(program.diagnostics.front(), "p"));
  }
  return steps;
}

TEST(TouchBox, MeetsAStraightWayOnItsNearFace) {
  EXPECT_EQ(first_contact(block(), {0, 0, 0}, {40, 20, 0}), (Point{10, 5, 0}));
  EXPECT_EQ(first_contact(block(), {40, 0, 0}, {0, 20, 0}), (Point{20, 10, 0}));
  EXPECT_EQ(first_contact(block(), {15, 0, 10}, {15, 0, -6}), (Point{15, 0, 2}));
}

TEST(TouchBox, IsMissedByAWayThatEndsBeforeOrPassesBy) {
  EXPECT_FALSE(first_contact(block(), {0, 0, 0}, {9, 0, 0}));
  EXPECT_FALSE(first_contact(block(), {0, 0, 3}, {40, 0, 3}));
  EXPECT_FALSE(first_contact(block(), {0, 0, 10}, {0, 0, -10}));
  EXPECT_FALSE(first_contact(block(), {0, 0, 0}, {-40, 0, 0}));
}

TEST(TouchBox, IsLeftThroughTheFaceInTheWay) {
  EXPECT_EQ(last_contact(block(), {15, 0, 0}, {15, 0, 8}), (Point{15, 0, 2}));
  EXPECT_EQ(last_contact(block(), {15, 0, 0}, {25, 10, 0}), (Point{20, 5, 0}));
  EXPECT_FALSE(last_contact(block(), {15, 0, 0}, {15, 0, 1}));
}

TEST(TouchBox, OnTheFaceIsTouched) {
  EXPECT_TRUE(touches(block(), {10, 0, 0}));
  EXPECT_TRUE(touches(block(), {15, 0, 2}));
  EXPECT_FALSE(touches(block(), {15, 0, 2.001}));
}

TEST(Probe, EndsAtRestWhereItTouchesAndKeepsThePlace) {
  const auto steps = steps_of("F60 G0 X15 Z10\nG38.2 Z-5\nG0 Z[#5063 + 4]\nX#5070");
  EXPECT_EQ(steps, (std::vector<std::string>{
                       "1: rapid to 15 0 10", "2: line to 15 0 2 feed 1 exact stop",
                       "3: rapid to 15 0 6", "4: rapid to 1 0 6", "5: program end 0"}));
}

TEST(Probe, GivesThePlaceInTheCoordinatesOfTheProgram) {
  const auto steps = steps_of("F60 G10 L2 P1 X3 Z1\nG0 X12 Z9\nG38.2 Z-5\nG0 Z8\nX#5061 Z#5063");
  EXPECT_EQ(steps.at(1), "3: line to 15 0 2 feed 1 exact stop");
  EXPECT_EQ(steps.at(3), "5: rapid to 15 0 2");
}

TEST(Probe, TouchesWithTheTipOfTheToolUnderG43) {
  EXPECT_EQ(steps_of("F60 G43.1 Z30\nG0 X15 Z10\nG38.2 Z-5").at(1),
            "3: line to 15 0 32 feed 1 exact stop");
}

TEST(Probe, InVainIsAnErrorOrANoughtIn5070) {
  EXPECT_EQ(steps_of("F60 G38.2 X5").back(), "p:1:5: error: G38.2 met nothing [E0854]");
  EXPECT_EQ(steps_of("F60 G0 X15\nG38.4 X16").back(),
            "p:2:1: error: G38.4 ended in contact [E0854]");
  const auto steps = steps_of("F60 G38.3 X5\nG0 X#5070");
  EXPECT_EQ(steps.at(0), "1: line to 5 0 0 feed 1 exact stop");
  EXPECT_EQ(steps.at(1), "2: rapid to 0 0 0");
}

TEST(Probe, WithoutASurfaceSaysSo) {
  EXPECT_EQ(first_message("F60 G38.2 X5"),
            "1:5: error: G38.2 met nothing (the machine file has no [probe])");
  EXPECT_EQ(first_message("F60 G38.5 X5"),
            "1:5: error: G38.5 begins without contact (the machine file has no [probe])");
}

TEST(Probe, AwayFromContactEndsWhereItIsLost) {
  EXPECT_EQ(steps_of("F60 G0 X15\nG38.4 Z9").at(1), "2: line to 15 0 2 feed 1 exact stop");
  const auto steps = steps_of("F60 G0 X15 Z10\nG38.2 Z-5\nG38.4 Z9\nG0 X#5070");
  EXPECT_EQ(steps.at(2), "4: rapid to 1 0 2");
}

TEST(Probe, TowardsContactMustNotBeginThere) {
  EXPECT_EQ(steps_of("F60 G0 X15\nG38.3 Z-9").back(),
            "p:2:1: error: G38.3 begins in contact [E0852]");
}

TEST(Probe, IsAModeOfItsOwn) {
  EXPECT_EQ(steps_of("F60 G38.3 X5\nX15").at(1), "2: line to 10 0 0 feed 1 exact stop");
}

}  // namespace
}  // namespace kerf::parser
