#include "programs/kerf/report/limit_band.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(LimitBand, IsExactWhileThereIsRoom) {
  LimitBand band;
  for (int tick = 0; tick < 1000; ++tick) {
    band.add(tick, tick < 400 ? Constraint::path_jerk : Constraint::programmed);
  }
  const auto intervals = band.intervals();
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_EQ(intervals[1].tick, 400);
  EXPECT_EQ(intervals[1].limit, Constraint::programmed);
}

TEST(LimitBand, ShowsWhatMostTicksOfABucketHaveHoweverLongTheRun) {
  LimitBand band;
  constexpr int kTicks = 1'000'000;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Constraint long_one = tick < kTicks / 2 ? Constraint::path_jerk : Constraint::programmed;
    band.add(tick, tick % 3 == 0 ? Constraint::junction : long_one);
  }
  const auto intervals = band.intervals();
  ASSERT_EQ(intervals.size(), 2U);
  EXPECT_EQ(intervals[0].limit, Constraint::path_jerk);
  EXPECT_NEAR(static_cast<double>(intervals[1].tick), kTicks / 2.0, 1024.0);
}

TEST(LimitBand, OfNothingIsEmpty) {
  EXPECT_TRUE(LimitBand().intervals().empty());
}

}  // namespace
}  // namespace kerf::program
