// Ramps below limit curves made by hand.
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/classical/limit_curve_cuts.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead::test {
namespace {

using Samples = std::vector<Slope::Sample>;
using Indices = std::vector<std::size_t>;

constexpr profiles::RampLimits kLimits{.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e6};

TEST(RampCuts, AreNotWhereTheLimitCurveAllowsOneAcceleration) {
  Samples samples;
  for (int i = 0; i <= 100; ++i) {
    samples.push_back({.distance_mm = 0.1 * i, .v_mm_s = std::sqrt(2.0 * 500.0 * 0.1 * i)});
  }
  EXPECT_EQ(ramp_cuts(samples, kLimits), Indices{});
}

TEST(RampCuts, AreNotWhereTheMachineIsSlowerThanTheLimitCurve) {
  EXPECT_EQ(ramp_cuts({{0.0, 1.0}, {1e-3, 90.0}, {1e-2, 91.0}, {50.0, 100.0}}, kLimits), Indices{});
}

TEST(RampCuts, AreNotWhereTheRampMayWaitAtItsFoot) {
  EXPECT_EQ(ramp_cuts({{0.0, 10.0}, {1.0, 10.0}, {2.0, 90.0}, {50.0, 100.0}}, kLimits), Indices{});
}

// Of 4 nm, which one acceleration of 8 um/s^2 keeps: 75 mm with it take more than an hour.
TEST(RampCuts, LieBehindATinyFeatureAtTheFoot) {
  EXPECT_EQ(ramp_cuts({{0.0, 0.0}, {4e-6, 8e-6}, {0.4, 90.0}, {75.0, 90.0}}, kLimits), Indices{1});
}

// From rest 10 fm on no feedrate of a nanometre a second is reached at 1e6 mm/s^3.
TEST(RampCuts, AreNotWhereTheJerkKeepsTheLimitCurveOutOfReach) {
  const Samples samples{{0.0, 0.0}, {1e-14, 1e-7}, {1.0, 90.0}, {75.0, 90.0}};
  EXPECT_EQ(ramp_cuts(samples, kLimits), Indices{});
  EXPECT_EQ(ramp_cuts(samples, {.acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = kUnbounded}),
            Indices{1});
}

TEST(RampCuts, LieBehindFeaturesOfEachSize) {
  const Samples samples{{0.0, 0.0},  {1e-9, 1e-6}, {1e-6, 1e-3},
                        {1e-3, 1.0}, {1.0, 40.0},  {100.0, 90.0}};
  const Indices cuts = ramp_cuts(samples, kLimits);
  ASSERT_FALSE(cuts.empty());
  double sum_s = 0.0;
  std::size_t from = 0;
  for (const std::size_t to : {cuts.front(), cuts.back(), samples.size() - 1}) {
    if (to > from) {
      sum_s += 2.0 * (samples[to].distance_mm - samples[from].distance_mm) /
               (samples[from].v_mm_s + samples[to].v_mm_s);
    }
    from = to;
  }
  // The fastest: 4 ms below each of the small features, then 1000 mm/s^2 up to 90 mm/s.
  EXPECT_LT(sum_s, 3.0);
}

}  // namespace
}  // namespace kerf::lookahead::test
