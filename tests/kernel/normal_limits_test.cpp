// Limits across the path, seen in the ticks.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "curves/position.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

// Second differences of the positions, without their share along the path.
double most_across_mm_s2(const std::vector<Setpoint>& ticks, double period_s) {
  double most = 0.0;
  for (std::size_t i = 2; i < ticks.size(); ++i) {
    const Eigen::Vector3d before = curves::vec(ticks[i - 2].position_mm);
    const Eigen::Vector3d here = curves::vec(ticks[i - 1].position_mm);
    const Eigen::Vector3d after = curves::vec(ticks[i].position_mm);
    const Eigen::Vector3d along = (after - before).normalized();
    const Eigen::Vector3d second = (after - 2.0 * here + before) / (period_s * period_s);
    most = std::max(most, (second - second.dot(along) * along).norm());
  }
  return most;
}

// Found by reading: where the axes alone have a velocity, a blend of two rapids had none, and the
// limits across it came to nothing: 1,085 mm/s2 across the path for 500, and with the S-curve an
// axis' jerk at twice its limit.
TEST(NormalLimits, HoldInABlendOfRapidsWhereTheAxesAloneHaveAVelocity) {
  for (const ProfileKind profile :
       {ProfileKind::time_optimal, ProfileKind::s_curve, ProfileKind::sine}) {
    for (const char* text : {"G21 G90 G64 P0.05\nG0 X10\nG0 Y10\nM2\n",
                             "G21 G90 G64 P0.05\nG0 X10\nG0 X4 Y8\nG0 X20 Y3\nM2\n"}) {
      MachineSettings settings;
      settings.limits.normal_acceleration_mm_s2 = 500.0;
      for (MotionLimits& axis : settings.limits.axes) {
        axis = {.velocity_mm_s = 250.0, .acceleration_mm_s2 = 2500.0, .jerk_mm_s3 = 50'000.0};
      }
      Kernel kernel(settings, {.profile = {.kind = profile}});
      kernel.feed(text);
      kernel.finish();
      const std::vector<Setpoint> ticks = rest_of(kernel);
      EXPECT_LE(most_across_mm_s2(ticks, settings.limits.period_s), 1.01 * 500.0)
          << name_of(profile) << ": " << text;
    }
  }
}

}  // namespace
}  // namespace kerf::test
