#include "parser/modal/coordinates.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kerf::parser {
namespace {

void expect_near(const Point& found, const Point& wanted) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(found[axis], wanted[axis], 1e-12) << "axis " << axis;
  }
}

TEST(Coordinates, ArePlainUntilAnOffsetIsSet) {
  Coordinates here;
  EXPECT_TRUE(here.plain());
  here.set_work(3, {{1.0, 2.0, 3.0}, 30.0});
  EXPECT_TRUE(here.plain()) << "G57 is not chosen";
  here.select(3);
  EXPECT_FALSE(here.plain());
  here.select(0);
  EXPECT_TRUE(here.plain());
  here.set_tool({0.0, 0.0, 12.5});
  EXPECT_FALSE(here.plain());
}

// rs274: G10 L2 P2 X10 Y20 Z5 R30, G55 G0 X1 Y2 Z3 goes to 9.8660 22.2321 8.0000.
TEST(Coordinates, TurnAboutTheOriginOfTheWorkOffset) {
  Coordinates here;
  here.set_work(1, {{10.0, 20.0, 5.0}, 30.0});
  here.select(1);
  const double half = 0.5;
  const double root = std::sqrt(3.0) / 2.0;
  expect_near(here.to_machine({1.0, 2.0, 3.0}),
              {10.0 + root - 2.0 * half, 20.0 + half + 2.0 * root, 8.0});
  expect_near(here.turned_to_machine({1.0, 0.0, 4.0}), {root, half, 4.0});
}

TEST(Coordinates, PutTheLocalOffsetInsideTheTurnAndTheToolOutside) {
  Coordinates here;
  here.set_work(0, {{100.0, 0.0, 0.0}, 90.0});
  here.set_local({1.0, 0.0, 0.0});
  here.set_tool({10.0, 0.0, 7.0});
  expect_near(here.to_machine({2.0, 0.0, 0.0}), {110.0, 3.0, 7.0});
}

TEST(Coordinates, GoBackToWhereTheyCameFrom) {
  Coordinates here;
  here.set_work(0, {{1.5, -7.25, 3.0}, 33.0});
  here.set_local({0.1, 0.2, 0.3});
  here.set_tool({4.0, 5.0, 6.0});
  const Point program{12.0, -34.0, 56.0};
  expect_near(here.to_program(here.to_machine(program)), program);
}

TEST(Coordinates, ScaleFirstThenTurnTheProgram) {
  Coordinates here;
  here.set_scaling({{1.0, 1.0, 0.0}, {2.0, 2.0, 1.0}});
  expect_near(here.to_machine({3.0, 1.0, 5.0}), {5.0, 1.0, 5.0});
  here.set_program_turn({{1.0, 1.0, 0.0}, 90.0});
  expect_near(here.to_machine({3.0, 1.0, 5.0}), {1.0, 5.0, 5.0});
  here.set_local({10.0, 0.0, 0.0});
  here.set_work(0, {{0.0, 100.0, 0.0}, 90.0});
  expect_near(here.to_machine({3.0, 1.0, 5.0}), {-5.0, 111.0, 5.0});
  expect_near(here.to_program({-5.0, 111.0, 5.0}), {3.0, 1.0, 5.0});
  EXPECT_TRUE(here.shaped());
}

TEST(Coordinates, ReachToTheExtendedWorkOffsets) {
  Coordinates here;
  EXPECT_EQ(here.work(Coordinates::kSystems + 299).origin_mm, Point{});
  here.select(Coordinates::kSystems + 4);
  here.set_work(Coordinates::kSystems + 4, {{7.0, 0.0, 0.0}, 0.0});
  expect_near(here.to_machine({1.0, 0.0, 0.0}), {8.0, 0.0, 0.0});
}

TEST(Coordinates, QuarterTurnsAreExact) {
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const Turn turn = turn_from_degrees(90.0 * quarter);
    const int within = ((quarter % 4) + 4) % 4;
    EXPECT_EQ(turn.cosine, within == 0 ? 1.0 : within == 2 ? -1.0 : 0.0) << quarter;
    EXPECT_EQ(turn.sine, within == 1 ? 1.0 : within == 3 ? -1.0 : 0.0) << quarter;
  }
}

}  // namespace
}  // namespace kerf::parser
