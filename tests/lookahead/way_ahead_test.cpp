#include "lookahead/optimum/way_ahead.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/lookahead/braking_from.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kShortLine_mm = 0.02;

// Found with a client: 5,000 of them took a quarter of a second, for nothing.
TEST(WayAhead, OverManyBlocksEndsWhereAGentleSCurveRests) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks = blocks_of(straight(9000, kShortLine_mm, 250.0), limits);
  const WayAhead way(from_begin_of(blocks, 160.0), limits);
  const double gentle_mm = 1.0 + 160.0 * 160.0 / 2000.0 + 160.0 * 2000.0 / 5e4;
  EXPECT_TRUE(way.knows(gentle_mm));
  EXPECT_FALSE(way.knows(gentle_mm + 2.0 * kShortLine_mm));
  const WayAhead fast(from_begin_of(blocks, 250.0), limits);
  EXPECT_EQ(fast.block_of(fast.cells().back()), WayAhead::kMaxBlocks) << "no more have room";
}

TEST(WayAhead, IsKnownToItsEndWhereThatIsNear) {
  const PlanLimits limits = mill();
  const std::vector<Block> few = blocks_of(straight(40, kShortLine_mm, 250.0), limits);
  const WayAhead way(from_begin_of(few, 160.0), limits);
  EXPECT_TRUE(way.knows(1e9));
}

}  // namespace
}  // namespace kerf::lookahead::test
