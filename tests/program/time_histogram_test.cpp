#include "programs/kerf/report/time_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

TEST(TimeHistogram, IsEmptyAtFirst) {
  const TimeHistogram times;
  EXPECT_EQ(times.count(), 0U);
  EXPECT_EQ(times.mean_s(), 0.0);
  EXPECT_EQ(times.worst_s(), 0.0);
  EXPECT_EQ(times.quantile_s(0.999), 0.0);
  EXPECT_TRUE(times.steps().empty());
}

// Against a sorted list of the same times.
TEST(TimeHistogram, KnowsEachQuantileToASixteenthAndNeverTooShort) {
  std::mt19937_64 random(7);
  std::lognormal_distribution<double> distribution(9.0, 3.0);
  TimeHistogram times;
  std::vector<double> all;
  double sum = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    const auto time_ns = static_cast<std::int64_t>(distribution(random));
    times.add(time_ns);
    all.push_back(static_cast<double>(time_ns) * 1e-9);
    sum += all.back();
  }
  std::sort(all.begin(), all.end());
  for (const double share : {0.0001, 0.01, 0.5, 0.9, 0.999, 1.0}) {
    const double exact_s = all[static_cast<std::size_t>(std::ceil(share * 20'000.0)) - 1];
    EXPECT_GE(times.quantile_s(share), exact_s * (1.0 - 1e-12)) << share;
    EXPECT_LE(times.quantile_s(share), exact_s * (1.0 + 1.0 / 16.0) + 1e-12) << share;
  }
  EXPECT_DOUBLE_EQ(times.worst_s(), all.back());
  EXPECT_NEAR(times.mean_s(), sum / 20'000.0, 1e-12 * sum);
}

TEST(TimeHistogram, PutsEachTimeIntoOneStep) {
  TimeHistogram times;
  times.add(-5);
  for (const std::int64_t time_ns :
       std::initializer_list<std::int64_t>{900, 1'500, 1'600, 40'000, 3'000'000'000}) {
    times.add(time_ns);
  }
  const auto steps = times.steps();
  std::uint64_t sum = 0;
  for (const auto& step : steps) {
    sum += step.count;
  }
  EXPECT_EQ(sum, 6U);
  ASSERT_GE(steps.size(), 3U);
  EXPECT_DOUBLE_EQ(steps[0].up_to_s, 1e-6);
  EXPECT_EQ(steps[0].count, 2U);
  EXPECT_DOUBLE_EQ(steps[1].up_to_s, 2e-6);
  EXPECT_EQ(steps[1].count, 2U);
  EXPECT_DOUBLE_EQ(steps.back().up_to_s, 5.0);
  EXPECT_EQ(steps.back().count, 1U);
}

TEST(TimeHistogram, AddsAnotherOne) {
  TimeHistogram times;
  times.add(1000);
  TimeHistogram more;
  more.add(3000);
  more.add(std::int64_t{1} << 60U);  // beyond all cells
  times.add(more);
  EXPECT_EQ(times.count(), 3U);
  EXPECT_DOUBLE_EQ(times.worst_s(), 1152921504.606846976);
  EXPECT_DOUBLE_EQ(times.quantile_s(1.0), times.worst_s());
}

}  // namespace
}  // namespace kerf::program
