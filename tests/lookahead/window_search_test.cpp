// How many cells a plan of the time optimum takes.
#include "lookahead/optimum/window_search.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// Beside a rest cells are divided.
constexpr std::size_t kDivided = 300;

class Searches final : public PlanObserver {
 public:
  void pushed(const Block& /*block*/) const override {}
  void cut(const BlockCuts& /*cuts*/) const override {}
  void planned(const PlannedSegment& /*segment*/) const override {}
  void took_classical(std::size_t /*blocks*/) const override {}
  void searched(const PlanSearch& search) const override { searches_.push_back(search); }

  [[nodiscard]] const std::vector<PlanSearch>& all() const { return searches_; }

 private:
  mutable std::vector<PlanSearch> searches_;
};

// Half circles, left and right in turn: at each joint the curvature jumps.
std::vector<parser::Move> half_circles(int count, double radius_mm) {
  std::vector<parser::Move> moves;
  for (int i = 0; i < count; ++i) {
    const double x = 2.0 * radius_mm * i;
    moves.push_back(arc_move({.ends = {{x, 0, 0}, {x + 2.0 * radius_mm, 0, 0}},
                              .centre = {x + radius_mm, 0, 0},
                              .clockwise = i % 2 == 0},
                             60.0));
  }
  return moves;
}

std::vector<PlanSearch> searches_over(const std::vector<parser::Move>& moves,
                                      const PlanLimits& limits) {
  const auto searches = std::make_shared<Searches>();
  plan(blocks_of(moves, limits),
       {.limits = limits, .profile = Profile{ProfileKind::time_optimal}, .observer = searches});
  return searches->all();
}

TEST(WindowSearch, TakesAThousandCellsFromARestAsInMotion) {
  const std::vector<PlanSearch> searches = searches_over(half_circles(300, 5.0), mill());
  ASSERT_GT(searches.size(), 3U);
  EXPECT_TRUE(searches.front().from_rest);
  EXPECT_GE(searches.front().cells, kCellsOfPlan);
  for (const PlanSearch& search : searches) {
    EXPECT_LE(search.cells, kCellsOfPlan + kDivided);
  }
}

// From 60 mm/s it brakes over 225 mm, most of what a thousand cells are long.
TEST(WindowSearch, TakesMoreFromARestWhereThePlanBrakesForItsEndForLong) {
  const PlanLimits slow =
      axis_limits({.velocity_mm_s = 200.0, .acceleration_mm_s2 = 8.0, .jerk_mm_s3 = 200.0});
  const std::vector<PlanSearch> searches = searches_over(half_circles(300, 50.0), slow);
  ASSERT_GT(searches.size(), 1U);
  EXPECT_TRUE(searches[0].from_rest);
  EXPECT_LE(searches[0].cells, kCellsOfPlan + kDivided);
  EXPECT_TRUE(searches[1].from_rest);
  EXPECT_GT(searches[1].cells, 2 * kCellsOfPlan);
}

// Up and down in turn, 2 mm apart.
parser::Move wave(int points) {
  curves::NurbsData data{.degree = 3, .points = {}, .knots = {0, 0, 0, 0}};
  for (int i = 0; i < points; ++i) {
    data.points.push_back({.position_mm = {2.0 * i, i % 4 < 2 ? 3.0 : -3.0, 0.0}});
    if (i > 3) {
      data.knots.push_back(i - 3);
    }
  }
  data.knots.insert(data.knots.end(), 4, points - 3);
  return nurbs_move(data, 60.0);
}

TEST(WindowSearch, TakesAllOfAFirstBlockThatIsComparedWithTheClassicalPlan) {
  const std::vector<PlanSearch> searches = searches_over({wave(40)}, mill());
  ASSERT_FALSE(searches.empty());
  EXPECT_GT(searches.front().cells, kCellsOfPlan + kDivided);
}

TEST(WindowSearch, TakesAThousandCellsOfAFirstBlockThatIsNot) {
  const std::vector<PlanSearch> searches = searches_over({wave(100)}, mill());
  ASSERT_GT(searches.size(), 3U);
  EXPECT_GE(searches.front().cells, kCellsOfPlan);
  EXPECT_LE(searches.front().cells, kCellsOfPlan + kDivided);
}

}  // namespace
}  // namespace kerf::lookahead::test
