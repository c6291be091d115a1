// Of many deviations the largest, and the one farthest beyond its tolerance.
#include <gtest/gtest.h>

#include "smoothing/path_deviations.hpp"

namespace kerf::smoothing {
namespace {

TEST(PathDeviations, ALargeOneWithinItsToleranceDoesNotHideASmallerOneBeyondIts) {
  PathDeviations all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  all.add({.distance_mm = 0.02, .line = 2, .tolerance_mm = 0.01});
  all.add({.distance_mm = 0.5, .line = 3, .tolerance_mm = 1.0});
  EXPECT_EQ(all.largest.line, 1U);
  EXPECT_EQ(all.worst.line, 2U);
}

TEST(PathDeviations, NoneIsTheWorstWhereAllAreWithinTheirTolerances) {
  PathDeviations all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  EXPECT_EQ(all.worst.distance_mm, 0.0);
  EXPECT_EQ(all.worst.tolerance_mm, 0.0);
}

TEST(PathDeviations, OfTwoPathsAreThoseOfBoth) {
  PathDeviations merged;
  merged.add({.distance_mm = 0.02, .line = 2, .tolerance_mm = 0.01});
  PathDeviations all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  all.add(merged);
  EXPECT_EQ(all.largest.line, 1U);
  EXPECT_EQ(all.worst.line, 2U);
}

}  // namespace
}  // namespace kerf::smoothing
