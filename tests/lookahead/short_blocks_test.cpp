// Curves so short that a tick passes over the whole of one: its chord cuts the corner that they
// make of the lines beside them.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/lookahead/block_chords.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

constexpr double kTurn_rad = 0.23;
constexpr double kFineTolerance_mm = 2.6e-5;

// Curvature is 0 at both ends.
curves::NurbsData corner(const Position& at, double arm_mm) {
  curves::NurbsData data{.degree = 5, .points = {}, .knots = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}};
  for (const double share : {1.0, 0.7, 0.4}) {
    data.points.push_back({.position_mm = {at[0] - share * arm_mm, at[1], at[2]}});
  }
  for (const double share : {0.4, 0.7, 1.0}) {
    data.points.push_back({.position_mm = {at[0] + share * arm_mm * std::cos(kTurn_rad),
                                           at[1] + share * arm_mm * std::sin(kTurn_rad), at[2]}});
  }
  return data;
}

constexpr MotionLimits kSlowJerk{
    .velocity_mm_s = 100.0, .acceleration_mm_s2 = 2900.0, .jerk_mm_s3 = 1.2e5};
constexpr MotionLimits kFastJerk{
    .velocity_mm_s = 100.0, .acceleration_mm_s2 = 2900.0, .jerk_mm_s3 = 1e7};

PlanLimits with_tolerance(PlanLimits limits) {
  limits.chord_tolerance_mm = kFineTolerance_mm;
  return limits;
}

struct Rounded {
  double first_line_mm = 0.0;
  double arm_mm = 0.0;  // of the corner that the curve rounds
  double last_line_mm = 1.0;
};

std::vector<Block> rounded_corner(const Rounded& rounded, const PlanLimits& limits) {
  const curves::NurbsData curve = corner({rounded.first_line_mm, 0, 0}, rounded.arm_mm);
  const Position from = curve.points.front().position_mm;
  const Position to = curve.points.back().position_mm;
  const Position end{to[0] + rounded.last_line_mm * std::cos(kTurn_rad),
                     to[1] + rounded.last_line_mm * std::sin(kTurn_rad), 0};
  std::vector<Block> blocks = blocks_of(
      {line_move({{0, 0, 0}, from}, 100.0), nurbs_move(curve, 100.0), line_move({to, end}, 100.0)},
      limits);
  blocks[1].continues = true;
  blocks[2].continues = true;
  return blocks;
}

class ShortBlocks : public testing::TestWithParam<ProfileKind> {};

void expect_chords_kept(const Rounded& rounded, const PlanLimits& limits, ProfileKind kind) {
  const std::vector<Block> blocks = rounded_corner(rounded, limits);
  const Motion motion = plan(blocks, {.limits = limits, .profile = Profile{kind}});
  expect_contiguous(motion.phases());
  EXPECT_LE(worst_chord_error_mm(blocks, motion), limits.chord_tolerance_mm * (1.0 + 1e-3));
}

TEST_P(ShortBlocks, KeepTheChordOfATickThatPassesOverThem) {
  for (const PlanLimits& limits :
       {with_tolerance(path_limits(kSlowJerk)), with_tolerance(axis_limits(kSlowJerk))}) {
    for (int i = 0; i < 40; ++i) {
      const Rounded rounded{.first_line_mm = 0.2 + 0.0137 * i, .arm_mm = 3e-6 * std::pow(1.15, i)};
      SCOPED_TRACE(rounded.arm_mm);
      expect_chords_kept(rounded, limits, GetParam());
    }
  }
}

// So near the begin of the motion, a tick that passes over the curve speeds up on beyond it.
TEST_P(ShortBlocks, KeepTheChordOfATickThatAcceleratesOverThem) {
  for (const PlanLimits& limits :
       {with_tolerance(path_limits(kFastJerk)), with_tolerance(axis_limits(kFastJerk))}) {
    for (int i = 0; i < 40; ++i) {
      const Rounded rounded{.first_line_mm = 1.2e-4 * std::pow(1.15, i), .arm_mm = 8e-6};
      SCOPED_TRACE(rounded.first_line_mm);
      expect_chords_kept(rounded, limits, GetParam());
    }
  }
}

// So near the end of the motion, one that passes over the curve still brakes before it.
TEST_P(ShortBlocks, KeepTheChordOfATickThatBrakesOverThem) {
  for (const PlanLimits& limits :
       {with_tolerance(path_limits(kFastJerk)), with_tolerance(axis_limits(kFastJerk))}) {
    for (int i = 0; i < 40; ++i) {
      const Rounded rounded{.first_line_mm = 0.7 + 0.0137 * i,
                            .arm_mm = 8e-6,
                            .last_line_mm = 1.2e-4 * std::pow(1.15, i)};
      SCOPED_TRACE(rounded.last_line_mm);
      expect_chords_kept(rounded, limits, GetParam());
    }
  }
}

// A rest before the corner and one after it would cost some ticks, a crawl many more.
TEST_P(ShortBlocks, ArePassedInMotion) {
  const PlanLimits limits = with_tolerance(axis_limits(kSlowJerk));
  const std::vector<Block> blocks = rounded_corner({.first_line_mm = 0.5, .arm_mm = 3e-5}, limits);
  const Motion motion = plan(blocks, {.limits = limits, .profile = Profile{GetParam()}});
  const auto rests = std::count_if(motion.phases().begin(), motion.phases().end(),
                                   [](const interp::Phase& phase) { return phase.ends_at_rest; });
  EXPECT_EQ(rests, 2) << "the last motion, and the end of the program";
}

INSTANTIATE_TEST_SUITE_P(AllProfiles, ShortBlocks, all_profiles());

}  // namespace
}  // namespace kerf::lookahead::test
