// Junctions beside curves where limits of axes bind.
#include <gtest/gtest.h>

#include "lookahead/classical/segment_junction.hpp"
#include "lookahead/classical/split.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

TEST(AxisLimitJunction, LeavesRoomForTheThirdDerivativeWithinTheConstantVelocity) {
  const PlanLimits limits =
      axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 5e4});
  const curves::NurbsData curve = curves::testing::shipped_curve("trident7");
  const Position begin = curve.points.front().position_mm;
  const auto blocks = blocks_of(
      {line_move({{begin[0] - 10.0, begin[1], begin[2]}, begin}, 100.0), nurbs_move(curve, 100.0)},
      limits);
  const AxisLimitCurve axis_limits =
      scan_axis_limits(std::get<curves::NurbsCurve>(blocks[1].curve), 100.0, limits);
  const VelocitySegment line = whole_segment(blocks[0]);
  const VelocitySegment first = split(blocks[1], {axis_limits, limits}, 0.05).front();
  const Junction found{.feedrate_mm_s = 50.0, .constant_velocity_s = 0.003};
  const Junction junction = beside_axis_limits(
      found,
      {.blocks = {.before = &blocks[0], .after = &blocks[1]}, .before = &line, .after = &first},
      limits);
  const double v = junction.feedrate_mm_s;
  EXPECT_LT(v, found.feedrate_mm_s);
  EXPECT_GT(v, 0.0);
  EXPECT_LE(2.0 * v * junction.constant_velocity_s, first.length_mm);
  for (const PathSample& at : first.axis_limits) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double turn = std::abs(blocks[1].begin.first[k] - blocks[0].end.first[k]);
      if (at.s_mm <= v * junction.constant_velocity_s) {
        EXPECT_LE(v * turn / 1e-6 + std::abs(at.third_per_mm2[k]) * v * v * v, 5e4 * 1.001);
      }
    }
  }
}

TEST(AxisLimitJunction, LeavesAStopAndASmoothJunctionAsTheyAre) {
  EXPECT_EQ(beside_axis_limits({.feedrate_mm_s = 0.0, .constant_velocity_s = 0.003}, {}, {})
                .feedrate_mm_s,
            0.0);
  EXPECT_EQ(beside_axis_limits({.feedrate_mm_s = 30.0}, {}, {}).feedrate_mm_s, 30.0);
}

}  // namespace
}  // namespace kerf::lookahead::test
