#include "lookahead/optimum/way_ahead.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kLine_mm = 0.02;

std::vector<Block> dense_lines(int count, const PlanLimits& limits) {
  std::vector<parser::Move> moves;
  moves.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    moves.push_back(line_move({{kLine_mm * i, 0, 0}, {kLine_mm * (i + 1), 0, 0}}, 250.0));
  }
  return blocks_of(moves, limits);
}

BrakingFrom from_begin_of(const std::vector<Block>& blocks, double v_mm_s) {
  BrakingFrom from{.blocks = {}, .state = {.v_mm_s = v_mm_s}};
  for (const Block& block : blocks) {
    from.blocks.push_back(&block);
  }
  return from;
}

// Found with a client: 5,000 of them took a quarter of a second, to find that there is no room for
// a way to rest over so many.
TEST(WayAhead, EndsWhereAWayToRestHasMoreBlocksThanItMayHaveCells) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks = dense_lines(5000, limits);
  const BrakingFrom from = from_begin_of(blocks, 160.0);
  const WayAhead way(from, limits);
  const auto blocks_seen = way.block_of(way.cells().back()) + 1;
  EXPECT_GT(blocks_seen, WayAhead::kMaxBlocks);
  EXPECT_LE(blocks_seen, WayAhead::kMaxBlocks + 1);
  EXPECT_TRUE(way.knows(kLine_mm * WayAhead::kMaxBlocks));
  EXPECT_FALSE(way.knows(kLine_mm * (WayAhead::kMaxBlocks + 1)));
  for (const StopDistance distance : kStopDistances) {
    EXPECT_FALSE(find_any_braking(from, limits, distance));
  }
}

TEST(WayAhead, IsKnownToItsEndWhereThatIsNear) {
  const PlanLimits limits = mill();
  const std::vector<Block> few = dense_lines(40, limits);
  const WayAhead way(from_begin_of(few, 160.0), limits);
  EXPECT_TRUE(way.knows(1e9));
  const std::vector<Block> many = dense_lines(5000, limits);
  const auto stop = find_any_braking(from_begin_of(many, 15.0), limits, StopDistance::near);
  ASSERT_TRUE(stop);
  EXPECT_GT(stop->back().block, 5U) << "over several blocks";
}

}  // namespace
}  // namespace kerf::lookahead::test
