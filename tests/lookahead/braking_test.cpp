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

double way_mm(const std::vector<BrakingPart>& parts) {
  double sum_mm = 0.0;
  for (const BrakingPart& part : parts) {
    sum_mm += part.law.length_mm();
  }
  return sum_mm;
}

TEST(Braking, ThatIsLateIsTheShortestWayFoundSoFar) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks =
      blocks_of({nurbs_move(curves::testing::shipped_curve("butterfly"), 60.0)}, limits);
  int shorter = 0;
  for (double s_mm = 5.0; s_mm < 0.8 * blocks.front().length_mm; s_mm += 12.0) {
    SCOPED_TRACE(s_mm);
    BrakingFrom from = from_begin_of(blocks, 20.0);
    from.s_mm = s_mm;
    const auto shortest = find_braking(from, limits);
    if (!shortest) {
      continue;  // too fast in a bend
    }
    double last_mm = kUnbounded;
    for (int tries = 0; tries <= 32; ++tries) {
      int asked = 0;
      const auto found = find_braking(from, limits, [&] { return ++asked > tries; });
      ASSERT_TRUE(found);
      EXPECT_LE(asked, tries + 1);
      EXPECT_LE(way_mm(*found), last_mm);
      shorter += last_mm < kUnbounded && way_mm(*found) < last_mm ? 1 : 0;
      last_mm = way_mm(*found);
    }
    EXPECT_EQ(last_mm, way_mm(*shortest));
  }
  EXPECT_GT(shorter, 0);
}

// Found by a soak: a rest within a micrometre of a block's end is at that end, and no nearer one
// was ever found.
TEST(Braking, OverMicrometresToABlockEndIsFoundInAFewTries) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks = blocks_of(mixed_moves(), limits);
  for (const double v_mm_s : {0.004, 0.008, 0.016}) {
    for (double left_mm = 5e-7; left_mm < 2e-5; left_mm *= 1.1) {
      SCOPED_TRACE(left_mm);
      BrakingFrom from = from_begin_of(blocks, v_mm_s);
      from.blocks.erase(from.blocks.begin());
      from.s_mm = from.blocks.front()->length_mm - left_mm;
      int asked = 0;
      const auto found = find_braking(from, limits, [&] { return ++asked > 100; });
      EXPECT_TRUE(found);
      EXPECT_LE(asked, 20);
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
