#include <algorithm>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/smoothing/polylines.hpp"
#include "tests/smoothing/smoothed.hpp"

namespace kerf::test {
namespace {

constexpr std::uint64_t kShards = 10;
#ifdef KERF_SLOW_BUILD
constexpr std::uint64_t kPrograms = 200;
#else
constexpr std::uint64_t kPrograms = 2000;
#endif

class RandomSmoothing : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomSmoothing, StaysWithinTheTolerancesAndLeavesNoGap) {
  for (std::uint64_t seed = GetParam(); seed < kPrograms; seed += kShards) {
    const RandomMoves program = random_moves(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + ":" + program.what);
    if (program.moves.empty()) {
      continue;
    }
    const Smoothed smoothed = smooth(program.moves);
    ASSERT_FALSE(smoothed.segments.empty());
    EXPECT_EQ(faults_of_junctions(program.moves, smoothed), "");
    const double tolerance = std::max(program.tolerances.corner_mm, program.tolerances.merge_mm);
    // The points of the paths are 1e-5 mm off their chords.
    const double apart = apart_mm(points_of(smoothed), points_of(program.moves));
    EXPECT_LE(apart, tolerance + 3e-5);
    EXPECT_LE(apart, smoothed.deviation.distance_mm + 3e-5);
    EXPECT_LE(smoothed.deviation.distance_mm, tolerance * (1.0 + 1e-9));
  }
}

// Found by a soak: merged lines that turn back within Q, beside a corner within P. The tip of their
// needle is farther from the blend than any of the places that are looked at first.
TEST(Smoothing, TellsHowFarABlendIsFromANeedleOfMergedLines) {
  const RandomMoves program = random_moves(5002528, Size::small);
  const Smoothed smoothed = smooth(program.moves);
  const double apart = apart_mm(points_of(smoothed), points_of(program.moves));
  EXPECT_LE(apart, std::max(program.tolerances.corner_mm, program.tolerances.merge_mm) + 3e-5);
  EXPECT_LE(apart, smoothed.deviation.distance_mm + 3e-5);
}

// Found by a soak: two arcs, and a blend so long that chords of it are not the blend.
TEST(Smoothing, TellsHowFarABlendOfLongArcsIsFromTheirCorner) {
  const RandomMoves program = random_moves(13012251, Size::small);
  const Smoothed smoothed = smooth(program.moves);
  const double apart = apart_mm(points_of(smoothed), points_of(program.moves));
  EXPECT_NEAR(smoothed.deviation.distance_mm, apart, 1e-5);
}

// Found by a soak: a circle of 0.08 mm, its points rounded to micrometres. The chords' middles are
// not where they are nearest to its centre.
TEST(Smoothing, TellsHowFarAnArcIsFromTheChordsOfARoundedCircle) {
  const RandomMoves program = random_moves(602344, Size::small);
  const Smoothed smoothed = smooth(program.moves);
  ASSERT_EQ(smoothed.segments.size(), 1U);
  const double apart = apart_mm(points_of(smoothed), points_of(program.moves));
  EXPECT_NEAR(smoothed.deviation.distance_mm, apart, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomSmoothing, testing::Range<std::uint64_t>(0, kShards));

TEST(Smoothing, GivesTheSameToTheLastBitASecondTime) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const RandomMoves program = random_moves(seed);
    EXPECT_EQ(points_of(smooth(program.moves)), points_of(smooth(program.moves))) << seed;
  }
}

}  // namespace
}  // namespace kerf::test
