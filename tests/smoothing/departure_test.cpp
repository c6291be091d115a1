// Of many departures the largest, and the one farthest beyond its tolerance.
#include "smoothing/departure.hpp"

#include <gtest/gtest.h>

namespace kerf::smoothing {
namespace {

TEST(Departures, ALargeOneWithinItsToleranceDoesNotHideASmallerOneBeyondIts) {
  Departures all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  all.add({.distance_mm = 0.02, .line = 2, .tolerance_mm = 0.01});
  all.add({.distance_mm = 0.5, .line = 3, .tolerance_mm = 1.0});
  EXPECT_EQ(all.largest.line, 1U);
  EXPECT_EQ(all.worst.line, 2U);
}

TEST(Departures, NoneIsTheWorstWhereAllAreWithinTheirTolerances) {
  Departures all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  EXPECT_EQ(all.worst.distance_mm, 0.0);
  EXPECT_EQ(all.worst.tolerance_mm, 0.0);
}

TEST(Departures, OfTwoPathsAreThoseOfBoth) {
  Departures merged;
  merged.add({.distance_mm = 0.02, .line = 2, .tolerance_mm = 0.01});
  Departures all;
  all.add({.distance_mm = 0.9, .line = 1, .tolerance_mm = 1.0});
  all.add(merged);
  EXPECT_EQ(all.largest.line, 1U);
  EXPECT_EQ(all.worst.line, 2U);
}

}  // namespace
}  // namespace kerf::smoothing
