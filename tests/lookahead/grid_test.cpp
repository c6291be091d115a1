#include "lookahead/optimum/grid/grid.hpp"

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// A cell at the junction lasts a tick, of 1e-8 mm. Before it the motion is faster by decades, and
// so the cells are longer.
TEST(Grid, HasFewCellsBeforeAJunctionThatIsPassedAtNextToNoFeedrate) {
  const PlanLimits limits = mill();
  const Block block = blocks_of({line_move({{0, 0, 0}, {0.009, 0, 0}}, 50.0)}, limits).front();
  const std::vector<Cell> cells =
      grid_of(BlockPath(block, limits), {.beyond = {.v_end_mm_s = 1e-5}}, limits);
  EXPECT_LT(cells.size(), 200U);
  EXPECT_LT(cells.back().length_mm, 2e-8);
}

}  // namespace
}  // namespace kerf::lookahead::test
