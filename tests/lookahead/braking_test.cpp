#include "lookahead/optimum/braking.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/lookahead/braking_from.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kLine_mm = 0.02;

// From v, jerk J to the acceleration A, that acceleration, and jerk J to rest.
TEST(Braking, OverManyShortLinesIsThatOnTheLineWhichTheyMake) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks = blocks_of(straight(5000, kLine_mm, 250.0), limits);
  constexpr double v = 160.0;
  const BrakingFrom from = from_begin_of(blocks, v);
  const MotionLimits& axis = limits.axes[0];
  const double a = axis.acceleration_mm_s2;
  const double way_mm = v * v / (2.0 * a) + v * a / (2.0 * axis.jerk_mm_s3);
  const auto shortest = find_braking(from, limits);
  const auto any = find_any_braking({from}, limits);
  ASSERT_TRUE(shortest && any);
  for (const std::vector<BrakingPart>& parts : {*shortest, any->parts}) {
    std::size_t block = 0;
    double block_mm = 0.0;
    double s_mm = 0.0;
    double v_mm_s = v;
    for (const BrakingPart& part : parts) {
      ASSERT_EQ(part.block, block);
      ASSERT_NEAR(part.law.ramp().v_begin_mm_s, v_mm_s, 1e-8);
      ASSERT_NEAR(part.law.at(part.law.duration_s()).s_mm, part.s_end_mm - s_mm, 1e-11);
      v_mm_s = part.law.ramp().v_end_mm_s;
      s_mm = part.ends_block ? 0.0 : part.s_end_mm;
      block_mm += part.ends_block ? part.s_end_mm : 0.0;
      block += part.ends_block ? 1 : 0;
    }
    EXPECT_EQ(v_mm_s, 0.0);
    EXPECT_NEAR(block_mm + s_mm, way_mm, 1e-6 * way_mm);
    EXPECT_NEAR(static_cast<double>(block), way_mm / kLine_mm, 1.0);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
