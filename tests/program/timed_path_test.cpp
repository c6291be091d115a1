#include "programs/kerf/page/timed_path.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// A spiral that stands still for a while.
TimedPoint point_at(std::int64_t tick) {
  const double t = 1e-3 * static_cast<double>(std::min<std::int64_t>(tick, 40'000));
  return {.tick = tick,
          .position_mm = {50.0 * t * std::cos(t), 50.0 * t * std::sin(t), -0.1 * t},
          .rapid = tick > 1000 && tick <= 1500};
}

// The largest distance in one coordinate between the points given and the straight lines over time.
double largest_error_mm(const std::vector<TimedPoint>& kept, std::int64_t last_tick) {
  double most = 0.0;
  std::size_t i = 0;
  for (std::int64_t tick = 0; tick <= last_tick; ++tick) {
    while (i + 2 < kept.size() && kept[i + 1].tick < tick) {
      ++i;
    }
    const TimedPoint& a = kept[i];
    const TimedPoint& b = kept[i + 1];
    const double share = static_cast<double>(tick - a.tick) / static_cast<double>(b.tick - a.tick);
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = a.position_mm[k] + share * (b.position_mm[k] - a.position_mm[k]);
      most = std::max(most, std::abs(at - point_at(tick).position_mm[k]));
    }
  }
  return most;
}

TEST(TimedPath, KeepsPlaceAndTimeWithinItsTolerance) {
  TimedPath path({.tolerance_mm = 0.01});
  for (std::int64_t tick = 0; tick <= 50'000; ++tick) {
    path.add(point_at(tick));
  }
  const std::vector<TimedPoint> points = path.points();
  EXPECT_EQ(path.tolerance_mm(), 0.01);
  EXPECT_LT(points.size(), 5000U);
  EXPECT_EQ(points.front().tick, 0);
  EXPECT_EQ(points.back().tick, 50'000);
  EXPECT_LE(largest_error_mm(points, 50'000), 0.01 * (1.0 + 1e-9));
}

TEST(TimedPath, HasBoundedMemoryAndSaysWhatThatCosts) {
  TimedPath path({.tolerance_mm = 1e-6, .max_points = 500});
  for (std::int64_t tick = 0; tick <= 50'000; ++tick) {
    path.add(point_at(tick));
    ASSERT_LE(path.points().size(), tick % 1000 == 0 ? 501U : 50'001U);
  }
  EXPECT_GT(path.tolerance_mm(), 1e-6);
  EXPECT_LE(largest_error_mm(path.points(), 50'000), path.tolerance_mm());
}

TEST(TimedPath, DividesWhereARapidBeginsAndEnds) {
  TimedPath path({.tolerance_mm = 1e9});
  for (std::int64_t tick = 0; tick <= 3000; ++tick) {
    path.add(point_at(tick));
  }
  const std::vector<TimedPoint> points = path.points();
  ASSERT_EQ(points.size(), 4U);
  EXPECT_EQ(points[1].tick, 1000);
  EXPECT_EQ(points[2].tick, 1500);
  EXPECT_EQ(points[2].rapid, true);
  EXPECT_EQ(points[3].rapid, false);
  EXPECT_TRUE(path.tells_rapids());
}

// Found with the dots of an engraving: thinning them went on for ever.
TEST(TimedPath, HasBoundedMemoryWhereRapidsBeginAndEndEverywhere) {
  TimedPath path({.tolerance_mm = 1e-6, .max_points = 500});
  for (std::int64_t tick = 0; tick <= 50'000; ++tick) {
    TimedPoint point = point_at(tick);
    point.rapid = tick / 3 % 2 == 0;
    path.add(point);
  }
  const std::vector<TimedPoint> points = path.points();
  EXPECT_LE(points.size(), 501U);
  EXPECT_GT(points.size(), 50U);
  EXPECT_LE(largest_error_mm(points, 50'000), path.tolerance_mm());
  EXPECT_FALSE(path.tells_rapids());
}

}  // namespace
}  // namespace kerf::program
