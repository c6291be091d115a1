// Moves that are as good as none, among ordinary ones: every limit at every tick, the end where the
// program says, never a hang, in all modes and profiles.
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "tests/kernel/degenerate_program.hpp"
#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/run.hpp"

namespace kerf::test {
namespace {

using profiles::ProfileKind;

constexpr std::uint64_t kDegenerateShards = 10;
#ifdef KERF_SLOW_BUILD
constexpr std::uint64_t kDegeneratePrograms = 200;
#else
constexpr std::uint64_t kDegeneratePrograms = 2000;
#endif

// Every second by the default profile.
ProfileKind kind_of(std::uint64_t seed) {
  return seed % 2 == 0 ? static_cast<ProfileKind>(seed / 2 % 7) : ProfileKind::time_optimal;
}

struct Lost {
  const char* text;
  Vec end_mm;
  double path_mm;
};

// Each had lost a move, stood still for ever or asked for all memory. Ends and lengths by hand.
TEST(DegenerateMoves, LeaveTheOthersOfTheirProgramAsTheyAre) {
  for (const Lost& lost : {
           Lost{"G1 F100 X[0.1+0.2-0.3]\nX1\nM2\n", {1, 0, 0}, 1.0},
           Lost{"G1 F100 X[1/10**17]\nX1\nY1\nX0\nY0\nM2\n", {0, 0, 0}, 4.0},
           Lost{"G1 F100 X[1/10**17]\nX100\nY50\nG0 Z5\nX0\nY0\nZ-10\nM2\n", {0, 0, -10}, 320.0},
           Lost{"G91 G1 F100\no1 repeat [3]\nX0.1\no1 endrepeat\no2 repeat [1]\nX-0.3\n"
                "o2 endrepeat\nG90 X0\nX1\nY1\nX0\nY0\nM2\n",
                {0, 0, 0},
                4.6},
           Lost{"#1=[1/10**300/10**20]\nG1 F100 X#1\nX1\nM2\n", {1, 0, 0}, 1.0},
           Lost{"#1=[1/10**300/10**20]\nG1 F100 X#1\nM2\n", {0, 0, 0}, 0.0},
           Lost{"G64 P0 Q0.01\nG91 F100\nG0 X[2/10**10]\nG1 X[-7/10**10]\nX[7/10**10]\n"
                "G0 X[8/10**10]\nG4 P0.1\nG90 G1 X1\nM2\n",
                {1, 0, 0},
                1.0},
       }) {
    for (std::size_t kind = 0; kind < 7; ++kind) {
      SCOPED_TRACE(std::string(lost.text) + " profile " + std::to_string(kind));
      Kernel kernel(default_machine(),
                    {.profile = profiles::Profile(static_cast<ProfileKind>(kind))});
      kernel.feed("G61\n");
      kernel.feed(lost.text);
      kernel.finish();
      const interp::Setpoint last = rest_of(kernel).back();
      EXPECT_FALSE(kernel.fault()) << kernel.fault()->what;
      EXPECT_EQ(last.position_mm, lost.end_mm);
      EXPECT_NEAR(last.s_mm, lost.path_mm, 1e-9);
    }
  }
}

class DegeneratePrograms : public testing::TestWithParam<std::uint64_t> {};

TEST_P(DegeneratePrograms, KeepEveryLimitAndEndWhereTheySay) {
  for (std::uint64_t seed = GetParam(); seed < kDegeneratePrograms && !HasFailure();
       seed += kDegenerateShards) {
    const Way way{.kind = kind_of(seed)};
    SCOPED_TRACE("seed " + std::to_string(seed) + ", profile " +
                 std::string(profiles::name_of(way.kind)));
    const RandomProgram program = degenerate_program(seed);
    const JudgedRun run = judged_run(program, random_machine(seed, Spread::common), way);
    EXPECT_EQ(run.complaint, "") << program.text;
    const Vec& at = run.last.position_mm;
    const Vec& end = program.end_mm;
    EXPECT_LE(std::hypot(at[0] - end[0], at[1] - end[1], at[2] - end[2]), kDegenerateEnd_mm)
        << program.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, DegeneratePrograms,
                         testing::Range<std::uint64_t>(0, kDegenerateShards));

}  // namespace
}  // namespace kerf::test
