#include "machine/touch_surface.hpp"

#include <gtest/gtest.h>

namespace kerf::machine {
namespace {

// The top at Z2, the sides at X10 and X20, open to the other sides.
TouchSurface block() {
  TouchBox box;
  box.max_mm[2] = 2.0;
  box.min_mm[0] = 10.0;
  box.max_mm[0] = 20.0;
  return box;
}

std::optional<Position> contact(const TouchSurface& surface, const Position& from,
                                const Position& to) {
  return first_contact(surface, {.from_mm = from, .to_mm = to});
}

std::optional<Position> end(const TouchSurface& surface, const Position& from, const Position& to) {
  return end_of_contact(surface, {.from_mm = from, .to_mm = to});
}

TEST(TouchSurface, ABoxIsMetOnItsNearFace) {
  EXPECT_EQ(contact(block(), {0, 0, 0}, {40, 20, 0}), (Position{10, 5, 0}));
  EXPECT_EQ(contact(block(), {40, 0, 0}, {0, 20, 0}), (Position{20, 10, 0}));
  EXPECT_EQ(contact(block(), {15, 0, 10}, {15, 0, -6}), (Position{15, 0, 2}));
}

TEST(TouchSurface, ABoxIsMissedByAWayThatEndsBeforeOrPassesBy) {
  EXPECT_FALSE(contact(block(), {0, 0, 0}, {9, 0, 0}));
  EXPECT_FALSE(contact(block(), {0, 0, 3}, {40, 0, 3}));
  EXPECT_FALSE(contact(block(), {0, 0, 10}, {0, 0, -10}));
  EXPECT_FALSE(contact(block(), {0, 0, 0}, {-40, 0, 0}));
}

TEST(TouchSurface, ABoxIsLeftThroughTheFaceInTheWay) {
  EXPECT_EQ(end(block(), {15, 0, 0}, {15, 0, 8}), (Position{15, 0, 2}));
  EXPECT_EQ(end(block(), {15, 0, 0}, {25, 10, 0}), (Position{20, 5, 0}));
  EXPECT_FALSE(end(block(), {15, 0, 0}, {15, 0, 1}));
}

TEST(TouchSurface, OnTheFaceIsTouched) {
  EXPECT_TRUE(touches(block(), {10, 0, 0}));
  EXPECT_TRUE(touches(block(), {15, 0, 2}));
  EXPECT_FALSE(touches(block(), {15, 0, 2.001}));
}

TEST(TouchSurface, APlaneIsMetFromItsNormalsSideAndLeftBackwards) {
  const TouchSurface plane = TouchPlane{.point_mm = {0, 0, 1}, .normal = {0, 3, 4}};
  // 3 y + 4 (z - 1) = 0
  EXPECT_EQ(contact(plane, {0, 0, 5}, {0, 0, -3}), (Position{0, 0, 1}));
  EXPECT_EQ(contact(plane, {2, 8, 1}, {2, -8, 1}), (Position{2, 0, 1}));
  EXPECT_FALSE(contact(plane, {0, 0, 5}, {0, 0, 6}));
  EXPECT_FALSE(contact(plane, {0, 0, 5}, {7, 0, 5}));
  EXPECT_EQ(end(plane, {0, 0, -3}, {0, 0, 5}), (Position{0, 0, 1}));
  EXPECT_FALSE(end(plane, {0, 0, -3}, {0, 0, -5}));
}

TEST(TouchSurface, ASphereIsMetOnItsNearSideAndLeftOnItsFar) {
  const TouchSurface sphere = TouchSphere{.centre_mm = {0, 0, 0}, .radius_mm = 5};
  EXPECT_EQ(contact(sphere, {10, 3, 0}, {-10, 3, 0}), (Position{4, 3, 0}));
  EXPECT_EQ(end(sphere, {0, 3, 0}, {-10, 3, 0}), (Position{-4, 3, 0}));
  EXPECT_FALSE(contact(sphere, {10, 6, 0}, {-10, 6, 0}));
  EXPECT_FALSE(contact(sphere, {10, 0, 0}, {20, 0, 0}));
  EXPECT_FALSE(contact(sphere, {10, 0, 0}, {6, 0, 0}));
}

// Two cells along X: a roof with its ridge of 4 at x = 10.
TouchSurface roof() {
  return HeightMap{
      .origin_mm = {0, 0}, .spacing_mm = {10, 20}, .columns = 3, .heights_mm = {0, 4, 0, 0, 4, 0}};
}

TEST(TouchSurface, AHeightMapIsMetFromAboveAndFromTheSide) {
  EXPECT_EQ(contact(roof(), {5, 5, 9}, {5, 5, -9}), (Position{5, 5, 2}));
  EXPECT_EQ(contact(roof(), {0.5, 5, 2}, {19, 5, 2}), (Position{5, 5, 2}));
  EXPECT_EQ(contact(roof(), {-5, 5, -1}, {15, 5, -1}), (Position{0, 5, -1}));  // its outline
  EXPECT_EQ(end(roof(), {10, 5, 2}, {20, 5, 2}), (Position{15, 5, 2}));
  EXPECT_EQ(end(roof(), {10, 5, -1}, {30, 5, -1}), (Position{20, 5, -1}));
}

// Farther beside it than the grid has lines.
TEST(TouchSurface, AHeightMapIsMetFromFarBesideIt) {
  EXPECT_EQ(contact(roof(), {-984, 5, -1}, {40, 5, -1}), (Position{0, 5, -1}));
  EXPECT_EQ(contact(roof(), {1044, 5, 2}, {20, 5, 2}), std::nullopt);
  EXPECT_EQ(contact(roof(), {1034, 5, 2}, {10, 5, 2}), (Position{15, 5, 2}));
  EXPECT_FALSE(contact(roof(), {-984, -990, -1}, {40, -34, -1}));  // passes by
}

TEST(TouchSurface, AHeightMapEndsWithItsGrid) {
  EXPECT_FALSE(contact(roof(), {-5, 5, 9}, {-5, 5, -9}));
  EXPECT_FALSE(contact(roof(), {5, 21, 9}, {5, 21, -9}));
  EXPECT_TRUE(touches(roof(), {10, 20, 4}));
  EXPECT_FALSE(touches(roof(), {10, 20, 4.1}));
}

TEST(HeightMapText, IsAGridInAnyOrder) {
  const auto map = read_height_map("# x y z\n0 0 1\n10,0,2\n\n10 5 4\n0 5 3\n");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->columns, 2u);
  EXPECT_EQ(map->spacing_mm, (std::array<double, 2>{10.0, 5.0}));
  EXPECT_EQ(map->heights_mm, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
}

TEST(HeightMapText, MayHaveRemarksSignsAndRoundedPlaces) {
  const auto map = read_height_map(
      "0 0 1 # a corner\n+0.333 0 2\n0.667 0 3\n1 0 4 #\n"
      "0 1 5\n0.333 1 6\n0.667 1 7\n1 1 -8\n");
  ASSERT_TRUE(map);
  EXPECT_EQ(map->columns, 4u);
  EXPECT_EQ(map->heights_mm.back(), -8.0);
  EXPECT_EQ(read_height_map("0 0 +-1\n").error().line, 1u);
}

TEST(HeightMapText, ThatIsNoneIsRefusedWithItsLine) {
  EXPECT_EQ(read_height_map("0 0 1\n0 1\n").error().line, 2u);
  EXPECT_EQ(read_height_map("0 0 1\n10 0 nan\n").error().line, 2u);
  EXPECT_FALSE(read_height_map(""));
  EXPECT_FALSE(read_height_map("0 0 1\n10 0 1\n"));
  EXPECT_FALSE(read_height_map("0 0 1\n10 0 1\n0 5 1\n"));
  EXPECT_FALSE(read_height_map("0 0 1\n1 0 1\n10 0 1\n0 5 1\n1 5 1\n10 5 1\n"));
  EXPECT_EQ(read_height_map("0 0 1\n10 0 2\n10 5 4\n10 5 3\n").error().line, 4u);
}

}  // namespace
}  // namespace kerf::machine
