#include "programs/kerf/report/limit_band.hpp"

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(LimitBand, IsExactWhileThereIsRoom) {
  LimitBand band;
  for (int tick = 0; tick < 1000; ++tick) {
    band.add(tick, tick < 400 ? Constraint::path_jerk : Constraint::programmed);
  }
  const auto stretches = band.stretches();
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[1].tick, 400);
  EXPECT_EQ(stretches[1].limit, Constraint::programmed);
}

TEST(LimitBand, ShowsWhatMostTicksOfABucketHaveHoweverLongTheRun) {
  LimitBand band;
  constexpr int kTicks = 1'000'000;
  for (int tick = 0; tick < kTicks; ++tick) {
    const Constraint long_one = tick < kTicks / 2 ? Constraint::path_jerk : Constraint::programmed;
    band.add(tick, tick % 3 == 0 ? Constraint::junction : long_one);
  }
  const auto stretches = band.stretches();
  ASSERT_EQ(stretches.size(), 2U);
  EXPECT_EQ(stretches[0].limit, Constraint::path_jerk);
  EXPECT_NEAR(static_cast<double>(stretches[1].tick), kTicks / 2.0, 1024.0);
}

TEST(LimitBand, OfNothingIsEmpty) {
  EXPECT_TRUE(LimitBand().stretches().empty());
}

}  // namespace
}  // namespace kerf::program
