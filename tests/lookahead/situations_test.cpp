// [Sigmoid, section 4.3]: two feedrates, a length and limits leave the peak or cruise v2 free. The
// paper finds v2 from quartic equations, of which each transition has the one of the limit that
// binds it: four situations. Here every v2 of a fine grid is tried.
#include <algorithm>
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kCap_mm_s = 100.0;
constexpr double kShape = 3.3;  // [Sigmoid, table 1]

struct Tried {
  double time_s = kUnbounded;
  double v_mm_s = 0.0;
};

double length_mm(const Transition& up, const Transition& down) {
  return up.length_mm() + down.length_mm();
}

// The fastest of all v2 with transitions as short as the limits allow.
Tried fastest_of_grid(const VelocitySegment& segment, const SegmentEnds& ends,
                      const Profile& profile) {
  constexpr int kSteps = 4000;
  const double low = std::max(ends.v_begin_mm_s, ends.v_end_mm_s);
  Tried best;
  for (int i = 0; i <= kSteps; ++i) {
    const double v = low + (kCap_mm_s - low) * i / kSteps;
    const Transition up = profile.fastest({ends.v_begin_mm_s, v}, segment.limits.ramp);
    const Transition down = profile.fastest({v, ends.v_end_mm_s}, segment.limits.ramp);
    const double rest_mm = segment.length_mm - length_mm(up, down);
    const double time = up.duration_s() + down.duration_s() + rest_mm / v;
    if (rest_mm >= 0.0 && time < best.time_s) {
      best = {time, v};
    }
  }
  return best;
}

// Whether the acceleration binds the transition, not the jerk.
bool is_bound_by_acceleration(double change_mm_s, const profiles::RampLimits& ramp) {
  const Profile profile(ProfileKind::sigmoid, kShape);
  const profiles::RampLimits free{.acceleration_mm_s2 = 1e12, .jerk_mm_s3 = ramp.jerk_mm_s3};
  return profile.duration_s(change_mm_s, ramp) > profile.duration_s(change_mm_s, free);
}

TEST(Situations, AreTheFastestOfAllCruises) {
  const Profile profile(ProfileKind::sigmoid, kShape);
  std::mt19937_64 random(20221117);
  const auto draw = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  std::array<int, 4> seen{};  // bit 0: acceleration binds up, bit 1: down
  int cruises = 0;
  int peaks = 0;
  for (int i = 0; i < 600; ++i) {
    const SegmentEnds ends{draw(1.0, 99.0), draw(1.0, 99.0)};
    VelocitySegment segment = flat_segment(1.0, kCap_mm_s);
    segment.limits.ramp = {.acceleration_mm_s2 = draw(500.0, 4000.0), .jerk_mm_s3 = 55'000.0};
    const double direct_mm =
        profile.length_mm({ends.v_begin_mm_s, ends.v_end_mm_s}, segment.limits.ramp);
    segment.length_mm = direct_mm * draw(1.01, 4.0) + draw(0.0, 4.0);
    SCOPED_TRACE(testing::Message() << i << ": " << ends.v_begin_mm_s << " to " << ends.v_end_mm_s
                                    << " mm/s over " << segment.length_mm << " mm");
    const SegmentPlan plan = plan_segment(segment, ends, profile);
    const Tried tried = fastest_of_grid(segment, ends, profile);
    EXPECT_LE(plan.duration_s(), tried.time_s * (1.0 + 1e-12));
    EXPECT_GE(plan.duration_s(), tried.time_s * (1.0 - 1e-3));
    const double peak =
        std::max(plan.acceleration.ramp().v_end_mm_s, plan.deceleration.ramp().v_begin_mm_s);
    const bool up = is_bound_by_acceleration(peak - ends.v_begin_mm_s, segment.limits.ramp);
    const bool down = is_bound_by_acceleration(peak - ends.v_end_mm_s, segment.limits.ramp);
    ++seen[(up ? 1U : 0U) + (down ? 2U : 0U)];
    ++(kind_of(plan) == "ACC + CF + DEC" ? cruises : peaks);
  }
  for (const int count : seen) {
    EXPECT_GT(count, 20);
  }
  EXPECT_GT(cruises, 50);
  EXPECT_GT(peaks, 50);
}

}  // namespace
}  // namespace kerf::lookahead::test
