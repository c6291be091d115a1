#include "programs/kerf/plot/path_cover.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

const PaperBox kSheet{.min = {.u_mm = -5.0, .v_mm = -5.0}, .max = {.u_mm = 5.0, .v_mm = 5.0}};

TEST(PathCover, ShowsALineOnceAndALowerOneOnTopOfIt) {
  PathCover cover(kSheet, 1.0);
  EXPECT_TRUE(cover.draw({-5.0, 0.0}, {5.0, 0.0}, 7));
  EXPECT_FALSE(cover.draw({-5.0, 0.1}, {5.0, 0.1}, 7));
  EXPECT_FALSE(cover.draw({5.0, 0.1}, {-5.0, 0.1}, 9));
  EXPECT_TRUE(cover.draw({-5.0, 0.1}, {5.0, 0.1}, 6));
  EXPECT_FALSE(cover.draw({-5.0, 0.0}, {5.0, 0.0}, 7));
}

TEST(PathCover, ShowsALineThatIsCoveredAlmostAllTheWay) {
  PathCover cover(kSheet, 1.0);
  cover.draw({-5.0, 0.0}, {4.0, 0.0}, 1);
  EXPECT_TRUE(cover.draw({-5.0, 0.0}, {5.0, 0.0}, 1));
  EXPECT_TRUE(cover.draw({0.0, -5.0}, {0.0, 5.0}, 1));
}

TEST(PathCover, TakesPointsOnAndBeyondItsEdge) {
  PathCover cover(kSheet, 1.0);
  EXPECT_TRUE(cover.draw({5.0, 5.0}, {5.0, 5.0}, 1));
  EXPECT_FALSE(cover.draw({6.0, 5.0}, {7.0, 5.0}, 1));
}

}  // namespace
}  // namespace kerf::program
