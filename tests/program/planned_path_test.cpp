#include "programs/kerf/page/planned_path.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// Along X from one place to the next.
smoothing::PathSegment line(double from_mm, double to_mm) {
  return {.curve = curves::Line::between({from_mm, 0.0, 0.0}, {to_mm, 0.0, 0.0}).value()};
}

TEST(PlannedPath, DrawsWhereItGoes) {
  PlannedPath path({.min_mm = {0.0, 0.0, 0.0}, .max_mm = {100.0, 0.0, 0.0}});
  path.add(line(0, 60));
  path.add(line(60, 30));
  const std::vector<TimedPoint> points = path.outline().points();
  ASSERT_EQ(points.size(), 3U);
  EXPECT_EQ(points[1].position_mm[0], 60.0);
  EXPECT_EQ(points[1].tick, 60'000'000);
  EXPECT_EQ(points[2].position_mm[0], 30.0);
  EXPECT_EQ(points[2].tick, 90'000'000);
}

}  // namespace
}  // namespace kerf::program
