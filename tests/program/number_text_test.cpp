#include "programs/kerf/io/number_text.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "programs/kerf/plot/feed_colours.hpp"
#include "programs/kerf/report/axis_ticks.hpp"

namespace kerf::program {
namespace {

TEST(ClockTime, CountsHoursMinutesSecondsAndMilliseconds) {
  EXPECT_EQ(clock_time(0.0), "0:00:00.000");
  EXPECT_EQ(clock_time(4.449), "0:00:04.449");
  EXPECT_EQ(clock_time(3723.004), "1:02:03.004");
  EXPECT_EQ(clock_time(59.9996), "0:01:00.000");
  EXPECT_EQ(clock_time(360'000.0), "100:00:00.000");
}

TEST(ClockTime, IsADashWhereThereIsNone) {
  EXPECT_EQ(clock_time(-1.0), "-");
  EXPECT_EQ(clock_time(std::numeric_limits<double>::quiet_NaN()), "-");
  EXPECT_EQ(clock_time(std::numeric_limits<double>::infinity()), "-");
}

TEST(ShortNumber, IsPlainBelowAMillionAndShortAbove) {
  EXPECT_EQ(short_number(0.0), "0");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(55'000.0), "55000");
  EXPECT_EQ(short_number(999'999.0), "999999");
  EXPECT_EQ(short_number(1'000'000.0), "1e6");
  EXPECT_EQ(short_number(1'241'000.0), "1.24e6");
  EXPECT_EQ(short_number(13e6), "1.3e7");
  EXPECT_EQ(short_number(-2.5e12), "-2.5e12");
}

TEST(FixedNumber, HasNoNegativeZero) {
  EXPECT_EQ(fixed_number(-0.0001, 3), "0.000");
  EXPECT_EQ(fixed_number(-0.001, 3), "-0.001");
  EXPECT_EQ(fixed_number(12.3456, 3), "12.346");
}

TEST(AxisTicks, AreRoundAndWithinTheRange) {
  EXPECT_EQ(axis_ticks({.min = 0.0, .max = 10.0}, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(axis_ticks({.min = -275.0, .max = 275.0}, 4), (std::vector<double>{-200, 0, 200}));
  for (const double tick : axis_ticks({.min = 1.3, .max = 1.4}, 6)) {
    EXPECT_GE(tick, 1.3 - 1e-9);
    EXPECT_LE(tick, 1.4 + 1e-9);
  }
}

TEST(AxisTicks, AreNeverManyMoreThanWanted) {
  for (const double width : {1e-9, 0.7, 1.0, 3.3, 55e3, 1e12}) {
    const std::size_t count = axis_ticks({.min = -width, .max = width}, 6).size();
    EXPECT_GE(count, 2U) << width;
    EXPECT_LE(count, 8U) << width;
  }
}

TEST(AxisTicks, AreNoneInARangeThatIsNone) {
  EXPECT_TRUE(axis_ticks({.min = 1.0, .max = 1.0}, 5).empty());
  EXPECT_TRUE(axis_ticks({.min = 0.0, .max = std::numeric_limits<double>::infinity()}, 5).empty());
}

TEST(FeedColours, RunFromSlowToFastWithoutARepetition) {
  EXPECT_EQ(colour_of(0), "#0d0887");
  for (std::size_t level = 1; level < kColourLevels; ++level) {
    EXPECT_NE(colour_of(level), colour_of(level - 1));
    EXPECT_EQ(colour_of(level).size(), 7U);
  }
  EXPECT_EQ(colour_level(0.0, 100.0), 0U);
  EXPECT_EQ(colour_level(100.0, 100.0), kColourLevels - 1);
  EXPECT_EQ(colour_level(250.0, 100.0), kColourLevels - 1);
  EXPECT_EQ(colour_level(10.0, 0.0), 0U);
}

}  // namespace
}  // namespace kerf::program
