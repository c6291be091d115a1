// The time optimum: never slower than closed forms and published references allow, never beyond a
// limit, in a bounded number of rounds.
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/solver/optimal_plan.hpp"
#include "tests/curves/reference_nurbs.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

// A program's only block from rest to rest.
OptimalPlan plan_of(const Block& block, const PlanLimits& limits) {
  const BlockPath path(block, limits);
  const PathAt at = [&path](const Cell&, double s_mm) { return path.at(s_mm); };
  CellSequence sequence{.begin = {}, .cells = grid_of(path, {}, limits)};
  refine_to_rest(sequence.cells, RestAt::begin, at, limits);
  refine_to_rest(sequence.cells, RestAt::end, at, limits);
  auto plan = OptimalPlan::find(std::move(sequence), at, limits);
  EXPECT_TRUE(plan.has_value());
  return plan.value_or(OptimalPlan{});
}

PlanLimits limits_of(const MotionLimits& each, bool on_axes, double chord_mm) {
  PlanLimits limits;
  limits.path.velocity_mm_s = each.velocity_mm_s;
  limits.chord_tolerance_mm = chord_mm;
  if (on_axes) {
    limits.axes.fill({.velocity_mm_s = kUnbounded,
                      .acceleration_mm_s2 = each.acceleration_mm_s2,
                      .jerk_mm_s3 = each.jerk_mm_s3});
  } else {
    limits.path = each;
  }
  return limits;
}

Block only_block(const parser::Move& move, const PlanLimits& limits) {
  std::vector<Block> blocks;
  EXPECT_TRUE(append_blocks(move, limits, blocks).has_value());
  EXPECT_EQ(blocks.size(), 1U);
  return blocks.front();
}

// The fastest rest to rest over a straight line under v, a and jerk (docs/math.md, 2.3): seven
// phases, of which those vanish that find no room.
double straight_s(double length_mm, const MotionLimits& limits) {
  const auto [v, a, j] = limits;
  const auto ramp = [a = a, j = j](double to) {
    return to * j >= a * a ? to / a + a / j : 2.0 * std::sqrt(to / j);
  };
  if (v * ramp(v) <= length_mm) {
    return length_mm / v + ramp(v);
  }
  double low = 0.0;
  double high = v;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (middle * ramp(middle) < length_mm ? low : high) = middle;
  }
  return 2.0 * ramp(low);
}

TEST(Optimum, OnALineIsTheSCurve) {
  const MotionLimits each{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3};
  const PlanLimits limits = limits_of(each, false, kUnbounded);
  for (const double length : {1e-3, 0.1, 1.0, 3.0, 10.0, 40.0, 500.0}) {
    const Block block = only_block(line_move({{0, 0, 0}, {length, 0, 0}}, 100.0), limits);
    const double time = plan_of(block, limits).duration_s();
    const double best = straight_s(length, each);
    EXPECT_GE(time, best * (1.0 - 1e-9)) << length;
    EXPECT_LE(time, best * 1.01) << length;
  }
}

TEST(Optimum, ASingleLineFromRestToRestIsTheSCurveInClosedForm) {
  const MotionLimits limits{
      .velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55000.0};
  const PlanLimits path = limits_of(limits, false, kUnbounded);
  for (const double length : {0.5, 30.0, 200.0}) {
    const Motion motion = plan(blocks_of({line_move({{0, 0, 0}, {length, 0, 0}})}, path),
                               {.limits = path, .profile = Profile(ProfileKind::time_optimal)});
    double sum = 0.0;
    for (const interp::Phase& phase : motion.phases()) {
      sum += phase.law.duration_s();
    }
    const double expected = straight_s(length, limits);
    EXPECT_NEAR(sum, expected, 1e-9 * expected);
  }
}

double time_of(const std::vector<parser::Move>& moves) {
  const PlanLimits limits = mill();
  const Motion motion = plan(blocks_of(moves, limits),
                             {.limits = limits, .profile = Profile(ProfileKind::time_optimal)});
  return motion.duration_s();
}

// Found with a client: 9,000 lines of 0.02 mm took nine times as long, for the rest at the window's
// end was braked for line by line. The look-ahead of 1,000 blocks reaches little farther over the
// shortest than the way to rest.
TEST(Optimum, OfManyShortLinesIsThatOfTheLineWhichTheyMake) {
  for (const double length_mm : {0.02, 0.1, 0.5}) {
    const int count = static_cast<int>(60.0 / length_mm);
    const double one_s = time_of({line_move({{0, 0, 0}, {80, 0, 0}}, 200.0)});
    std::vector<parser::Move> moves{line_move({{-20, 0, 0}, {0, 0, 0}}, 200.0)};
    for (const parser::Move& move : straight(count, length_mm, 200.0)) {
      moves.push_back(move);
    }
    EXPECT_NEAR(time_of(moves), one_s, (length_mm < 0.1 ? 0.05 : 0.01) * one_s) << length_mm;
  }
}

// Found with a client: the S-curve of the line alone was taken to be faster, at the cost of the
// curve per millimetre, and the whole curve followed the S-curve.
TEST(Optimum, OfALongCurveIsTheSameBehindALineThatLeadsIn) {
  constexpr std::size_t kPoints = 400;
  curves::NurbsData wave;
  wave.knots = curves::testing::uniform_knots(3, kPoints);
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x = 0.25 * static_cast<double>(i);
    wave.points.push_back({.position_mm = {x, 3.0 * std::sin(2.0 * x), 0.0}});
  }
  const curves::Position& end = wave.points[0].position_mm;
  const Eigen::Vector3d along =
      (curves::vec(wave.points[1].position_mm) - curves::vec(end)).normalized();
  const auto led_in_by = [&](double length_mm) {
    const Eigen::Vector3d begin = curves::vec(end) - length_mm * along;
    return time_of(
        {line_move({{begin[0], begin[1], begin[2]}, end}, 200.0), nurbs_move(wave, 200.0)});
  };
  const double short_s = led_in_by(3.0);
  EXPECT_LT(led_in_by(40.0), short_s + 37.0 / 100.0) << "over the line at half its feedrate";
}

TEST(Optimum, AtAVeryLowFeedrateTakesTheTimeOfTheCruise) {
  const MotionLimits each{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3};
  const PlanLimits limits = limits_of(each, true, 5e-4);
  const auto curve = curves::testing::shipped_curve("butterfly");
  const double feedrate = 1e-4;
  const Block block = only_block(nurbs_move(curve, feedrate), limits);
  const OptimalPlan plan = plan_of(block, limits);
  EXPECT_NEAR(plan.duration_s(), block.length_mm / feedrate, 1e-2 * block.length_mm / feedrate);
  EXPECT_LT(plan.cells().size(), 20000U);
}

// The butterfly lies in X and Y.
TEST(Optimum, IsNotSlowedByAnAxisThatRests) {
  const MotionLimits each{.velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3};
  PlanLimits limits = limits_of(each, true, 5e-4);
  const auto curve = curves::testing::shipped_curve("butterfly");
  const double time = plan_of(only_block(nurbs_move(curve, 100.0), limits), limits).duration_s();
  limits.axes[2] = {.velocity_mm_s = 1.0, .acceleration_mm_s2 = 10.0, .jerk_mm_s3 = 100.0};
  EXPECT_DOUBLE_EQ(plan_of(only_block(nurbs_move(curve, 100.0), limits), limits).duration_s(),
                   time);
}

struct Reference {
  std::string curve;
  bool on_axes = false;
  MotionLimits each{};
  double chord_mm = 0.0;
  double time_s = 0.0;
};

void PrintTo(const Reference& reference, std::ostream* out) {
  *out << reference.curve << (reference.on_axes ? " axis " : " path ")
       << reference.each.velocity_mm_s;
}

class OptimumOf : public testing::TestWithParam<Reference> {};

// The references (a sequential convex optimisation of b = v^2 on a uniform grid, good to about 0.2
// %) leave out the jerk of the launch from rest and of the landing, where the acceleration jumps in
// them: a line that is run at V, A and J from rest to rest takes A / J longer than they say. So
// that much is added at the most; see straight_s.
TEST_P(OptimumOf, IsWithinAPercentOfTheReferenceAndKeepsEveryLimit) {
  const Reference& reference = GetParam();
  const PlanLimits limits = limits_of(reference.each, reference.on_axes, reference.chord_mm);
  const auto curve = curves::testing::shipped_curve(reference.curve);
  const Block block = only_block(nurbs_move(curve, reference.each.velocity_mm_s), limits);
  const OptimalPlan plan = plan_of(block, limits);
  const auto& [v, a, j] = reference.each;
  const double launch = std::min(a / j, std::sqrt(v / j));
  EXPECT_LE(plan.duration_s(), 1.01 * reference.time_s + launch);
  EXPECT_GE(plan.duration_s(), 0.99 * reference.time_s);
  EXPECT_LE(plan.excess().largest(), 1.0);
  EXPECT_FALSE(plan.slowed_down());
}

constexpr MotionLimits kPaper{
    .velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55e3};
constexpr MotionLimits kSoft{
    .velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 20e3};
constexpr MotionLimits kFast{
    .velocity_mm_s = 200.0, .acceleration_mm_s2 = 2000.0, .jerk_mm_s3 = 30e3};

INSTANTIATE_TEST_SUITE_P(Shipped, OptimumOf,
                         testing::Values(Reference{"butterfly", false, kPaper, 5e-4, 4.36163},
                                         Reference{"butterfly", true, kPaper, 5e-4, 4.39685},
                                         Reference{"butterfly", true, kSoft, 1e-3, 5.35275},
                                         Reference{"butterfly", true, kFast, 1e-3, 4.05961},
                                         Reference{"trident7", true, kSoft, 1e-3, 0.97112},
                                         Reference{"mazatrol", true, kFast, 1e-3, 1.02648},
                                         Reference{"scroll", false, kPaper, 5e-4, 2.54942},
                                         Reference{"scroll", true, kFast, 1e-3, 2.19346},
                                         Reference{"rational4", true, kFast, 1e-3, 0.40139},
                                         Reference{"star", false, kSoft, 1e-3, 2.58361}));

// Six stages and six refinements of at most fifteen steps are allowed for; what is usual is far
// less.
TEST(Optimum, TakesABoundedNumberOfNewtonSteps) {
  for (const char* name : {"butterfly", "trident7", "mazatrol", "scroll", "rational4", "star"}) {
    for (const bool on_axes : {false, true}) {
      for (const MotionLimits& each : {kPaper, kSoft, kFast}) {
        const PlanLimits limits = limits_of(each, on_axes, 1e-3);
        const auto curve = curves::testing::shipped_curve(name);
        const Block block = only_block(nurbs_move(curve, each.velocity_mm_s), limits);
        EXPECT_LE(plan_of(block, limits).newton_steps(), 70)
            << name << (on_axes ? " axis " : " path ") << each.velocity_mm_s;
      }
    }
  }
}

curves::NurbsData bezier_of(const std::vector<curves::Position>& points) {
  curves::NurbsData data{.degree = static_cast<int>(points.size()) - 1, .points = {}, .knots = {}};
  for (const curves::Position& point : points) {
    data.points.push_back({.position_mm = point});
  }
  data.knots.assign(points.size(), 0.0);
  data.knots.insert(data.knots.end(), points.size(), 1.0);
  return data;
}

// Four stages and eight refinements of fifteen steps are the most there can be; near-cusps down to
// a radius of 1e-7 mm, beyond which the motion stops there, take no more than twice what is usual.
TEST(Optimum, TakesABoundedNumberOfNewtonStepsOnNearCusps) {
  std::vector<curves::NurbsData> all;
  for (const double crossing : {1e-1, 1e-2, 1e-3}) {
    all.push_back(bezier_of({{0, 0, 0}, {10.0 + crossing, 10, 0}, {-crossing, 10, 0}, {10, 0, 0}}));
  }
  for (const double rise : {1e-1, 1e-2, 2e-3}) {
    all.push_back(bezier_of({{0, 0, 0}, {10, rise, 0}, {0, 2.0 * rise, 0}}));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (const MotionLimits& each : {kPaper, kSoft, kFast}) {
      const PlanLimits limits = limits_of(each, true, 1e-3);
      const Block block = only_block(nurbs_move(all[i], each.velocity_mm_s), limits);
      const OptimalPlan plan = plan_of(block, limits);
      EXPECT_LE(plan.newton_steps(), 80) << i << " " << each.velocity_mm_s;
      EXPECT_LE(plan.excess().largest(), 1.0) << i;
      EXPECT_FALSE(plan.slowed_down()) << i;
    }
  }
}

}  // namespace
}  // namespace kerf::lookahead::test
