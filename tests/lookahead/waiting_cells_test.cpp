// Blocks as they wait for a plan: none is lost, whatever the look-ahead makes of their junctions.
#include "lookahead/optimum/grid/waiting_cells.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/path/junction.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// A line along X and an arc that turns off it by this angle.
std::vector<Block> line_and_arc(double turn_rad, const PlanLimits& limits) {
  const double x = std::cos(turn_rad);
  const double y = std::sin(turn_rad);
  const Position centre{10.0 - 20.0 * y, 20.0 * x, 0.0};
  const Position end{centre[0] + 20.0 * x, centre[1] + 20.0 * y, 0.0};
  return blocks_of({line_move({{0, 0, 0}, {10, 0, 0}}, 50.0),
                    arc_move({.ends = {{10, 0, 0}, end}, .centre = centre}, 50.0)},
                   limits);
}

double length_mm(const WaitingCells& waiting) {
  double sum_mm = 0.0;
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    sum_mm += waiting[i].length_mm;
  }
  return sum_mm;
}

// Between passing and stopping there are angles at which the classical schedule still passes and
// cells, which leave a little of the limits free, do not.
TEST(WaitingCells, LoseNoBlockWhereOnlyCellsStopAtItsBegin) {
  const PlanLimits limits = mill();
  int seen = 0;
  for (double turn = 0.005; turn < 1.5; turn *= 1.0005) {
    const std::vector<Block> blocks = line_and_arc(turn, limits);
    const JunctionQuery query{.before = &blocks[0], .after = &blocks[1]};
    if (junction_of(query, limits).feedrate_mm_s == 0.0 ||
        !cell_junction_of(query, limits).is_stop()) {
      continue;
    }
    ++seen;
    WaitingCells waiting(limits);
    Window<Block> window;
    for (const Block& block : blocks) {
      window.push_back(Block(block));
      waiting.push(window);
    }
    waiting.close(window);
    EXPECT_NEAR(length_mm(waiting), blocks[0].length_mm + blocks[1].length_mm, 1e-9) << turn;
  }
  EXPECT_GT(seen, 0);
}

// A line after a rest may wait as it is, but not where the motion is on it already.
TEST(WaitingCells, AreCellsOfABlockThatTheMotionIsOn) {
  const PlanLimits limits = mill();
  const std::vector<Block> blocks = blocks_of(
      {line_move({{0, 0, 0}, {10, 0, 0}}, 50.0), line_move({{10, 0, 0}, {0, 0, 0}}, 50.0)}, limits);
  ASSERT_EQ(junction_of({.before = &blocks[0], .after = &blocks[1]}, limits).feedrate_mm_s, 0.0);
  WaitingCells waiting(limits);
  Window<Block> window;
  for (const Block& block : blocks) {
    window.push_back(Block(block));
    waiting.push_as_cells(window);
  }
  waiting.close(window);
  waiting.begin_at({.block = 1, .s_mm = 0.001}, window);
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    EXPECT_LT(waiting[i].along.jerk_mm_s3, kUnbounded);
    EXPECT_LT(waiting[i].end.feedrate_mm_s, kUnbounded);
  }
  EXPECT_NEAR(length_mm(waiting), 9.999, 1e-9);
}

}  // namespace
}  // namespace kerf::lookahead::test
