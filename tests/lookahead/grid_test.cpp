#include "lookahead/optimum/grid/grid.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

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

// Of degree 4, with simple knots: the jerk of an axis has a kink at each of them.
TEST(Grid, EndsCellsWhereOnlyTheFourthDerivativeJumps) {
  curves::NurbsData data{.degree = 4, .points = {}, .knots = {0, 0, 0, 0, 0}};
  constexpr int kPoints = 12;
  for (int i = 0; i < kPoints; ++i) {
    data.points.push_back({.position_mm = {3.0 * i, 4.0 * std::sin(1.3 * i), std::cos(0.7 * i)}});
  }
  for (int knot = 1; knot <= kPoints - 5; ++knot) {
    data.knots.push_back(knot);
  }
  data.knots.insert(data.knots.end(), 5, kPoints - 4);
  const PlanLimits limits = mill();
  const Block block = blocks_of({nurbs_move(data, 100.0)}, limits).front();
  const std::vector<Cell> cells = grid_of(BlockPath(block, limits), {}, limits);
  const auto& curve = std::get<curves::NurbsCurve>(block.curve);
  for (int knot = 1; knot <= kPoints - 5; ++knot) {
    const double s_mm = curve.s_at(knot);
    const double nearest = std::abs(
        std::ranges::min(cells, {}, [s_mm](const Cell& c) { return std::abs(c.s_end_mm() - s_mm); })
            .s_end_mm() -
        s_mm);
    EXPECT_LT(nearest, 1e-9) << knot;
  }
}

// Two parabolas, almost straight: curvature jumps from 2e-6 to 6e-6 per mm, an axis' acceleration
// by 0.04 mm/s2 at 100 mm/s and by 4e-6 at 1 mm/s. Its jerk allows 50 within a tick.
TEST(BlockPath, HasNoJumpWhereNoAxisFeelsIt) {
  const curves::NurbsData data{.degree = 2,
                               .points = {{.position_mm = {0, 0, 0}},
                                          {.position_mm = {5, 0, 0}},
                                          {.position_mm = {15, 2e-4, 0}},
                                          {.position_mm = {20, 6e-4, 0}}},
                               .knots = {0, 0, 0, 1, 2, 2, 2}};
  const PlanLimits limits = mill();
  const auto jumps_at = [&](double feedrate_mm_s) {
    const Block block = blocks_of({nurbs_move(data, feedrate_mm_s)}, limits).front();
    return std::ranges::count_if(BlockPath(block, limits).breaks(),
                                 [](const BlockPath::Break& at) { return at.jump.has_value(); });
  };
  EXPECT_EQ(jumps_at(100.0), 1);
  EXPECT_EQ(jumps_at(1.0), 0);
}

}  // namespace
}  // namespace kerf::lookahead::test
