// A block that continues the one before by construction: nothing is asked of the junction that only
// rounding puts there.
#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "lookahead/optimum/grid/junction_share.hpp"
#include "lookahead/path/junction.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// So far out that rounding of coordinates turns the tangent of a small curve by some 1e-11.
constexpr double kFarOut_mm = 1e5;

using Points = std::array<Position, 6>;

curves::NurbsData bezier(const Points& points) {
  curves::NurbsData data{.degree = 5, .points = {}, .knots = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}};
  for (const Position& point : points) {
    data.points.push_back({.position_mm = point});
  }
  return data;
}

Points bow() {
  Points points{
      {{0, 0, 0}, {0.3, 0, 0}, {0.7, 0.1, 0.1}, {1.0, 0.5, 0.2}, {1.1, 1, 0}, {1, 1.4, 0}}};
  for (Position& point : points) {
    point[0] += kFarOut_mm;
    point[1] += kFarOut_mm;
  }
  return points;
}

// Both halves, by de Casteljau.
std::pair<Points, Points> halved(Points points) {
  std::pair<Points, Points> halves;
  for (std::size_t i = 0; i < points.size(); ++i) {
    halves.first[i] = points.front();
    halves.second[points.size() - 1 - i] = points[points.size() - 1 - i];
    for (std::size_t k = 0; k + i + 1 < points.size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        points[k][axis] = 0.5 * (points[k][axis] + points[k + 1][axis]);
      }
    }
  }
  return halves;
}

std::vector<Block> cut_bow(bool continues) {
  const auto [first, second] = halved(bow());
  std::vector<Block> blocks =
      blocks_of({nurbs_move(bezier(first), 100.0), nurbs_move(bezier(second), 100.0)}, mill());
  blocks.back().continues = continues;
  return blocks;
}

double largest_axis_jerk_mm_s3(const std::vector<Block>& blocks, const Motion& motion) {
  const auto at = [&](double t) {
    double s = motion.at(t).s_mm;
    std::size_t i = 0;
    while (i + 1 < blocks.size() && s > blocks[i].length_mm) {
      s -= blocks[i++].length_mm;
    }
    return curves::position_at(blocks[i].curve, s);
  };
  double largest = 0.0;
  for (double t = 3.0 * kTs; t < motion.duration_s(); t += 0.1 * kTs) {
    const std::array<Position, 4> x{at(t), at(t - kTs), at(t - 2 * kTs), at(t - 3 * kTs)};
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = x[0][k] - 3.0 * (x[1][k] - x[2][k]) - x[3][k];
      largest = std::max(largest, std::abs(difference) / (kTs * kTs * kTs));
    }
  }
  return largest;
}

TEST(ContinuingBlocks, ArePassedWithoutConstantVelocity) {
  std::vector<Block> compared = cut_bow(false);
  std::vector<Block> continuing = cut_bow(true);
  for (std::vector<Block>* blocks : {&compared, &continuing}) {
    blocks->back().begin.first[1] += 1e-5;
  }
  ASSERT_GT(
      junction_of({.before = &compared[0], .after = &compared[1]}, mill()).constant_velocity_s, 0.0)
      << "the turn is to show";
  const Junction junction =
      junction_of({.before = &continuing[0], .after = &continuing[1]}, mill());
  EXPECT_EQ(junction.constant_velocity_s, 0.0);
  EXPECT_EQ(junction.feedrate_mm_s,
            std::min(continuing[0].limits.feedrate_mm_s, continuing[1].limits.feedrate_mm_s));
}

TEST(ContinuingBlocks, JoinSmoothlyInTheTimeOptimum) {
  const std::vector<Block> blocks = cut_bow(true);
  EXPECT_TRUE(cell_junction_of({.before = &blocks[0], .after = &blocks[1]}, mill()).smooth);
}

TEST(ContinuingBlocks, StopWhereTheBlockBeforeStops) {
  std::vector<Block> blocks = cut_bow(true);
  blocks.front().stop_after = true;
  EXPECT_EQ(junction_of({.before = &blocks[0], .after = &blocks[1]}, mill()).feedrate_mm_s, 0.0);
  EXPECT_TRUE(cell_junction_of({.before = &blocks[0], .after = &blocks[1]}, mill()).is_stop());
}

// One path, cut or not, has one optimum.
TEST(ContinuingBlocks, TakeTheTimeOfTheWholeCurve) {
  const PlannerSettings settings{.limits = mill(), .profile = Profile{ProfileKind::time_optimal}};
  const std::vector<Block> whole = blocks_of({nurbs_move(bezier(bow()), 100.0)}, mill());
  const std::vector<Block> cut = cut_bow(true);
  const Motion of_whole = plan(whole, settings);
  const Motion of_cut = plan(cut, settings);
  EXPECT_NEAR(of_cut.duration_s(), of_whole.duration_s(), 2e-3 * of_whole.duration_s());
}

TEST(ContinuingBlocks, KeepTheJerkOfEachAxisUnderEveryLaw) {
  const double rounding = 8.0 * kFarOut_mm * 2.3e-16 / (kTs * kTs * kTs);
  const std::vector<Block> blocks = cut_bow(true);
  for (const ProfileKind kind :
       {ProfileKind::time_optimal, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
        ProfileKind::sine_series, ProfileKind::sigmoid}) {
    const Motion motion = plan(blocks, {.limits = mill(), .profile = Profile{kind}});
    EXPECT_LE(largest_axis_jerk_mm_s3(blocks, motion), 1.0001 * 5e4 + rounding)
        << profiles::name_of(kind);
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
