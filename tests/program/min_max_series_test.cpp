#include "programs/kerf/report/min_max_series.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(MinMaxSeries, IsExactWhileItHasRoom) {
  MinMaxSeries series(8);
  const std::vector<double> values{3.0, -1.0, 4.0, 1.0, -5.0, 9.0};
  for (std::size_t i = 0; i < values.size(); ++i) {
    series.add(static_cast<std::int64_t>(i), values[i]);
  }
  const auto points = series.points();
  ASSERT_EQ(points.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(points[i].tick, static_cast<std::int64_t>(i));
    EXPECT_EQ(points[i].value, values[i]);
  }
}

TEST(MinMaxSeries, KeepsAOneTickPeakInAMillionTicksAtItsTick) {
  MinMaxSeries series(100);
  constexpr std::int64_t kTicks = 1'000'000;
  for (std::int64_t tick = 0; tick < kTicks; ++tick) {
    const double value = tick == 777'777 ? 50.0 : tick == 123'456 ? -60.0 : 0.0;
    series.add(tick, value);
  }
  const auto points = series.points();
  EXPECT_LE(points.size(), 200U);
  EXPECT_GE(points.size(), 50U);
  const auto by_value = [](const SeriesPoint& a, const SeriesPoint& b) {
    return a.value < b.value;
  };
  const auto [low, high] = std::minmax_element(points.begin(), points.end(), by_value);
  EXPECT_EQ(low->tick, 123'456);
  EXPECT_EQ(low->value, -60.0);
  EXPECT_EQ(high->tick, 777'777);
  EXPECT_EQ(high->value, 50.0);
}

TEST(MinMaxSeries, GivesTheSmallestAndLargestOfEachBand) {
  MinMaxSeries series(4);
  for (std::int64_t tick = 0; tick < 16; ++tick) {
    series.add(tick, tick % 2 == 0 ? static_cast<double>(tick) : -1.0);
  }
  EXPECT_EQ(series.ticks_per_band(), 4);
  const auto bands = series.bands();
  ASSERT_EQ(bands.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(bands[i].tick, static_cast<std::int64_t>(4 * i));
    EXPECT_EQ(bands[i].min, -1.0);
    EXPECT_EQ(bands[i].max, static_cast<double>(4 * i + 2));
  }
}

TEST(MinMaxSeries, GivesPointsInTheOrderOfTimeAndOnlySuchAsWentIn) {
  MinMaxSeries series(16);
  std::vector<double> values;
  for (std::int64_t tick = 0; tick < 5000; ++tick) {
    values.push_back(std::sin(0.37 * static_cast<double>(tick)));
    series.add(tick, values.back());
  }
  const auto points = series.points();
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(points[i].value, values[static_cast<std::size_t>(points[i].tick)]);
    if (i > 0) {
      EXPECT_LT(points[i - 1].tick, points[i].tick);
    }
  }
}

TEST(MinMaxSeries, BearsGapsBetweenTicks) {
  MinMaxSeries series(4);
  for (std::int64_t tick = 0; tick < 10; ++tick) {
    series.add(tick * 1'000'000, static_cast<double>(tick));
  }
  const auto points = series.points();
  EXPECT_LE(points.size(), 8U);
  EXPECT_EQ(points.front().value, 0.0);
  EXPECT_EQ(points.back().value, 9.0);
}

}  // namespace
}  // namespace kerf::program
