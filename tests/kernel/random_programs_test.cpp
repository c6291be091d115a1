// Seeded random programs: every limit at every tick, every tick on the path, the chord between two
// ticks within the tolerance of it, the end where the program says, never a hang.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/kernel/environment.hpp"
#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_machine.hpp"

namespace kerf::test {
namespace {

using profiles::ProfileKind;

// KERF_RANDOM_PROGRAMS and KERF_RANDOM_SEED override count and first seed.
// Every so many seeds has limits that are spread over four decades between axes.
constexpr std::uint64_t kWide = 3;

void expect_clean(std::uint64_t seed, Mix mix, const Way& way) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", profile " +
               std::string(profiles::name_of(way.kind)) + ", window " +
               std::to_string(way.window_blocks));
  const MachineSettings settings =
      random_machine(seed, seed % kWide == 0 ? Spread::wide : Spread::common);
  mix.longest_mm = std::min(mix.longest_mm, unhurried_mm(settings));
  const RandomProgram program = random_program(seed, mix);
  const JudgedRun outcome = judged_run(program, settings, way);
  EXPECT_EQ(outcome.complaint, "") << program.text;
  EXPECT_EQ(outcome.last.position_mm, program.end_mm) << program.text;
  constexpr double kDegree_rad = 3.14159265358979323846 / 180.0;
  EXPECT_EQ(outcome.last.extra_rad_mm[0], program.end_a_deg * kDegree_rad) << program.text;
  EXPECT_EQ(outcome.last.extra_rad_mm[3], program.end_u_mm) << program.text;
}

constexpr std::uint64_t kShards = 8;
#ifdef KERF_SLOW_BUILD
constexpr std::uint64_t kPrograms = 800;
#else
constexpr std::uint64_t kPrograms = 10'000;
#endif

class RandomPrograms : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomPrograms, KeepEveryLimitAtEveryTickAndEndWhereTheySay) {
  const std::uint64_t count = from_environment("KERF_RANDOM_PROGRAMS", kPrograms) / kShards;
  const std::uint64_t first = from_environment("KERF_RANDOM_SEED", 1) + GetParam() * count;
  std::cout << "seeds " << first << " to " << first + count - 1 << "\n";
  for (std::uint64_t seed = first; seed < first + count && !testing::Test::HasFailure(); ++seed) {
    const Mix mix{.arcs = seed % 4 != 0,
                  .nurbs = seed % 4 == 1,
                  .extra = seed % 11 == 3,
                  .contour = seed % 8 == 0,
                  .blocks = seed % 8 == 0 ? 60 : 6};
    const Way way{.kind = static_cast<ProfileKind>(seed % 7),
                  .window_blocks = seed % 5 < 3 ? 2 + seed / 7 % 7 : 1000};
    expect_clean(seed, mix, way);
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomPrograms, testing::Range<std::uint64_t>(0, kShards));

}  // namespace
}  // namespace kerf::test
