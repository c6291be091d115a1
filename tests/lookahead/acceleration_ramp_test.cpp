// What a ramp takes at least, before the ramp is sought.
#include "lookahead/classical/acceleration_ramp.hpp"

#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "lookahead/classical/block_segments.hpp"
#include "tests/curves/shipped_curves.hpp"
#include "tests/lookahead/programs.hpp"
#include "tests/lookahead/velocity_segments.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(AccelerationRamp, IsNeverShorterThanItsLeastLength) {
  std::mt19937_64 random(20261130);
  const auto share = [&random] { return std::uniform_real_distribution<double>(0.0, 1.0)(random); };
  const PlanLimits limits = mill();
  int waited = 0;
  int shorter_than_twice = 0;
  int ramps = 0;
  for (const auto& [name, data] : curves::testing::shipped_curves()) {
    for (const ProfileKind kind : all_kinds()) {
      const Profile profile(kind);
      SCOPED_TRACE(name + ", " + std::string(profiles::name_of(kind)));
      const Block block = blocks_of({nurbs_move(data, 100.0)}, limits).front();
      for (const VelocitySegment& segment : segments_of(block, {limits, profile}, true)) {
        const double top = std::min(segment.rise.top_mm_s(), segment.limits.feedrate_mm_s);
        const double v_begin = std::min(segment.rise.bottom_mm_s(), top) * share();
        const RampRequest request{.ramp = {v_begin, v_begin + share() * (top - v_begin)},
                                  .may_wait = true};
        const double least_mm = least_length_mm(request, segment, profile);
        const AccelerationRamp ramp = acceleration_ramp(request, segment, profile);
        ASSERT_LE(least_mm, ramp.length_mm() * (1.0 + 1e-12));
        waited += ramp.delay_mm > 0.0 && kind != ProfileKind::trapezoid ? 1 : 0;
        shorter_than_twice += ramp.length_mm() < 2.0 * least_mm ? 1 : 0;
        ++ramps;
      }
    }
  }
  EXPECT_GT(waited, 0);
  EXPECT_GT(shorter_than_twice, ramps / 2);
}

}  // namespace
}  // namespace kerf::lookahead::test
