// Ticks that pass over an end of a curve: their chord is over a part of it and over what it meets.
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/lookahead/block_chords.hpp"
#include "tests/lookahead/programs.hpp"

namespace kerf::lookahead::test {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}
  double between(double least, double most) {
    return std::uniform_real_distribution<double>(least, most)(random_);
  }
  // As many of each size.
  double of_any_size(double least, double most) {
    return std::exp(between(std::log(least), std::log(most)));
  }

 private:
  std::mt19937_64 random_;
};

// Two lines and the curve that rounds their corner, with curvature 0 at both ends and sharper
// towards one of them.
std::vector<Block> uneven_corner(Random& random, const PlanLimits& limits) {
  const double turn_rad = random.between(0.05, 1.5);
  const double in_mm = random.of_any_size(1e-3, 1.0);
  const double out_mm = in_mm * random.of_any_size(0.05, 20.0);
  const double corner_mm = random.between(0.5, 3.0) + in_mm;
  const auto before = [&](double share) { return Position{corner_mm - share * in_mm, 0.0, 0.0}; };
  const auto after = [&](double share) {
    return Position{corner_mm + share * std::cos(turn_rad), share * std::sin(turn_rad), 0.0};
  };
  curves::NurbsData curve{.degree = 5, .points = {}, .knots = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1}};
  const double outer = random.between(0.5, 0.9);
  const double inner = random.between(0.1, 0.45);
  for (const double share : {1.0, outer, inner}) {
    curve.points.push_back({.position_mm = before(share)});
  }
  for (const double share : {inner, outer, 1.0}) {
    curve.points.push_back({.position_mm = after(share * out_mm)});
  }
  std::vector<Block> blocks =
      blocks_of({line_move({{0, 0, 0}, before(1.0)}, 100.0), nurbs_move(curve, 100.0),
                 line_move({after(out_mm), after(out_mm + random.between(0.5, 3.0))}, 100.0)},
                limits);
  blocks[1].continues = true;
  blocks[2].continues = true;
  return blocks;
}

class CurveEnds : public testing::TestWithParam<ProfileKind> {};

TEST_P(CurveEnds, KeepTheChordOfATickThatPassesOverThem) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    PlanLimits limits = path_limits({.velocity_mm_s = 100.0,
                                     .acceleration_mm_s2 = 2900.0,
                                     .jerk_mm_s3 = random.of_any_size(2e4, 1e7)});
    limits.chord_tolerance_mm = random.of_any_size(1e-4, 5e-3);
    const std::vector<Block> blocks = uneven_corner(random, limits);
    const Motion motion = plan(blocks, {.limits = limits, .profile = Profile{GetParam()}});
    EXPECT_LE(worst_chord_error_mm(blocks, motion), limits.chord_tolerance_mm * (1.0 + 1e-3));
  }
}

INSTANTIATE_TEST_SUITE_P(AllProfiles, CurveEnds, all_profiles());

}  // namespace
}  // namespace kerf::lookahead::test
