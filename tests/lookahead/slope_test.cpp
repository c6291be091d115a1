// The limit curve seen from the foot of a hill: how long a ramp must be made, or how late it
// begins.
#include "lookahead/classical/slope.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "lookahead/path/limits.hpp"

namespace kerf::lookahead::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;
using profiles::Transition;

constexpr profiles::RampLimits kRamp{.acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55'000.0};

TEST(Slope, DoesNotStretchARampThatStaysBelow) {
  const Profile profile{ProfileKind::s_curve};
  const Transition ramp = profile.fastest({0.0, 50.0}, kRamp);
  EXPECT_EQ(Slope{}.stretch_for(ramp), 1.0);
  const Slope high({{.distance_mm = 0.0, .v_mm_s = 60.0}, {.distance_mm = 1.0, .v_mm_s = 70.0}});
  EXPECT_EQ(high.stretch_for(ramp), 1.0);
}

TEST(Slope, StretchesARampUntilItTouches) {
  const Profile profile{ProfileKind::s_curve};
  const Transition ramp = profile.fastest({10.0, 50.0}, kRamp);
  const double length = 4.0 * ramp.length_mm();
  const Slope slope(
      {{.distance_mm = 0.0, .v_mm_s = 10.0}, {.distance_mm = length, .v_mm_s = 50.0}});
  const Transition stretched = ramp.stretched(slope.stretch_for(ramp));
  double nearest = 1e9;
  for (int i = 1; i <= 1000; ++i) {
    const auto point = stretched.at(stretched.duration_s() * i / 1000.0);
    const double allowed = 10.0 + 40.0 * std::min(point.s_mm / length, 1.0);
    EXPECT_LE(point.v_mm_s, allowed * (1.0 + 1e-3));
    nearest = std::min(nearest, allowed - point.v_mm_s);
  }
  EXPECT_LT(nearest, 0.05);
}

TEST(Slope, IsTheSameSideSeenFromFartherUp) {
  const Slope slope({{.distance_mm = 0.0, .v_mm_s = 20.0},
                     {.distance_mm = 1.0, .v_mm_s = 30.0},
                     {.distance_mm = 3.0, .v_mm_s = 70.0}});
  EXPECT_EQ(slope.bottom_mm_s(), 20.0);
  const Slope from = slope.from(2.0);
  EXPECT_EQ(from.bottom_mm_s(), 30.0);  // the sample below its foot: no more than is allowed there
  EXPECT_EQ(from.top_mm_s(), 70.0);
  EXPECT_EQ(from.allowed_from_mm(70.0), 1.0);
  EXPECT_EQ(slope.from(9.0).top_mm_s(), 70.0);
  EXPECT_TRUE(Slope{}.from(1.0).empty());
}

TEST(Slope, LooksThroughADipOnTheWayUp) {
  const Slope slope({{.distance_mm = 0.0, .v_mm_s = 20.0},
                     {.distance_mm = 1.0, .v_mm_s = 60.0},
                     {.distance_mm = 2.0, .v_mm_s = 30.0},
                     {.distance_mm = 3.0, .v_mm_s = 80.0}});
  EXPECT_EQ(slope.top_mm_s(), 80.0);
  const Profile profile{ProfileKind::s_curve};
  const Transition ramp = profile.fastest({20.0, 40.0}, {1e6, 1e9});
  // More than 30 mm/s is not allowed before the dip at 2 mm is over.
  const Transition stretched = ramp.stretched(slope.stretch_for(ramp));
  double s_at_30 = 0.0;
  for (int i = 0; i <= 10'000; ++i) {
    const auto point = stretched.at(stretched.duration_s() * i / 10'000.0);
    s_at_30 = point.v_mm_s <= 30.0 ? point.s_mm : s_at_30;
  }
  EXPECT_NEAR(s_at_30, 2.0, 0.1);
}

// Flat, then far above within the step between two ticks: where curvature jumps.
struct Step {
  double at_mm = 0.0;
  double low_mm_s = 0.0;

  [[nodiscard]] Slope slope() const {
    return Slope({{.distance_mm = 0.0, .v_mm_s = low_mm_s - 1.0},
                  {.distance_mm = 0.01, .v_mm_s = low_mm_s},
                  {.distance_mm = at_mm, .v_mm_s = low_mm_s},
                  {.distance_mm = at_mm + 0.001, .v_mm_s = 90.0}});
  }
};

TEST(Slope, StretchesARampForAStepWhereverItLies) {
  for (int kind = 1; kind <= static_cast<int>(ProfileKind::sigmoid); ++kind) {
    const Profile profile{static_cast<ProfileKind>(kind)};
    SCOPED_TRACE(profiles::name_of(profile.kind()));
    const Transition ramp = profile.fastest({40.0, 80.0}, kRamp);
    for (double low = 41.5; low < 79.0; low += 0.37) {
      const Step step{.at_mm = 1.3 * ramp.length_mm(), .low_mm_s = low};
      const Transition stretched = ramp.stretched(step.slope().stretch_for(ramp));
      double highest = 0.0;  // before the step
      for (int i = 0; i <= 10'000; ++i) {
        const auto point = stretched.at(stretched.duration_s() * i / 10'000.0);
        highest = point.s_mm > 0.01 && point.s_mm <= step.at_mm ? point.v_mm_s : highest;
      }
      ASSERT_LE(highest, low * (1.0 + 1e-4)) << low;
      ASSERT_GE(highest, low * (1.0 - 1e-3)) << low;
    }
  }
}

TEST(Slope, DelaysARampForAStepWhereverItLies) {
  const Profile profile{ProfileKind::trapezoid};
  const Transition ramp = profile.fastest({40.0, 80.0}, kRamp);
  for (double low = 41.5; low < 79.0; low += 0.37) {
    const Step step{.at_mm = 2.0, .low_mm_s = low};
    const double foot = step.slope().delay_for_mm(ramp);
    double highest = 0.0;
    for (int i = 0; i <= 10'000; ++i) {
      const auto point = ramp.at(ramp.duration_s() * i / 10'000.0);
      highest = foot + point.s_mm <= step.at_mm ? point.v_mm_s : highest;
    }
    ASSERT_LE(highest, low * (1.0 + 1e-4)) << low;
    ASSERT_GE(highest, low * (1.0 - 1e-3)) << low;
  }
}

// Of many lines, steep ones and flat ones, with a foot at which the ramp begins or above it.
Slope random_slope(std::mt19937_64& random, const profiles::Ramp& ramp, double length_mm) {
  const auto drawn = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  std::vector<Slope::Sample> samples;
  const double top_mm = length_mm * drawn(0.3, 3.0);
  double v_mm_s = ramp.v_begin_mm_s * drawn(1.0, 1.2) + drawn(0.0, 1.0);
  for (int i = 0; i <= 24; ++i) {
    samples.push_back({.distance_mm = top_mm * i / 24.0, .v_mm_s = v_mm_s});
    v_mm_s += (i % 5 == 3 ? 0.0 : drawn(0.0, 0.1)) * (ramp.v_end_mm_s - ramp.v_begin_mm_s);
  }
  samples.back().v_mm_s = std::max(v_mm_s, ramp.v_end_mm_s);
  return Slope(samples);
}

// Whether the ramp is above the slope at any of 20,000 points by more than a share of its feedrate.
bool is_above(const Slope& slope, const Transition& ramp, double share) {
  for (int i = 1; i <= 20'000; ++i) {
    const auto point = ramp.at(ramp.duration_s() * i / 20'000.0);
    if (slope.allowed_from_mm(point.v_mm_s * (1.0 - share)) > point.s_mm * (1.0 + 1e-9)) {
      return true;
    }
  }
  return false;
}

TEST(Slope, OfAnyShapeStretchesARampByWhatItNeedsAndNoMore) {
  std::mt19937_64 random(20261130);
  int stretched = 0;
  for (int round = 0; round < 400; ++round) {
    const int kind = 1 + round % static_cast<int>(ProfileKind::sigmoid);
    const Profile profile{static_cast<ProfileKind>(kind)};
    SCOPED_TRACE(std::string(profiles::name_of(profile.kind())) + ", round " +
                 std::to_string(round));
    const double v_begin = std::uniform_real_distribution<double>(0.0, 60.0)(random);
    const profiles::Ramp feedrates{v_begin, v_begin + 40.0};
    const Transition ramp = profile.fastest(feedrates, kRamp);
    const Slope slope = random_slope(random, feedrates, ramp.length_mm());
    const double factor = slope.stretch_for(ramp);
    ASSERT_FALSE(is_above(slope, ramp.stretched(factor), 1e-4));
    if (factor > 1.0) {
      ++stretched;
      ASSERT_TRUE(is_above(slope, ramp.stretched(0.999 * factor), 0.0));
    }
  }
  EXPECT_GT(stretched, 100);
}

}  // namespace
}  // namespace kerf::lookahead::test
