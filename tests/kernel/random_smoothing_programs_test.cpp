// Seeded random programs in G64, G61 and G61.1: every limit at every tick, the end where the
// program says, never a hang, the second run the same to the last bit. How far the path departs is
// judged by tests/smoothing.
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/smoothing_program.hpp"

namespace kerf::test {
namespace {

using profiles::ProfileKind;

constexpr std::uint64_t kSmoothedShards = 10;
#ifdef KERF_SLOW_BUILD
constexpr std::uint64_t kSmoothedPrograms = 200;
#else
constexpr std::uint64_t kSmoothedPrograms = 2000;
#endif

// Two of three by the default profile.
ProfileKind profile_of(std::uint64_t seed) {
  return seed % 3 == 0 ? static_cast<ProfileKind>(seed / 3 % 7) : ProfileKind::time_optimal;
}

class RandomSmoothingPrograms : public testing::TestWithParam<std::uint64_t> {};

TEST_P(RandomSmoothingPrograms, KeepEveryLimitAndEndWhereTheySay) {
  for (std::uint64_t seed = GetParam(); seed < kSmoothedPrograms; seed += kSmoothedShards) {
    const Way way{.kind = profile_of(seed)};
    SCOPED_TRACE("seed " + std::to_string(seed) + ", profile " +
                 std::string(profiles::name_of(way.kind)));
    const RandomProgram program = smoothing_program(seed);
    const JudgedRun run = judged_run(program, random_machine(seed, Spread::common), way);
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.last.position_mm, program.end_mm);
  }
}

INSTANTIATE_TEST_SUITE_P(Shard, RandomSmoothingPrograms,
                         testing::Range<std::uint64_t>(0, kSmoothedShards));

std::vector<interp::Setpoint> smoothed_ticks_of(const RandomProgram& program,
                                                const MachineSettings& settings,
                                                std::size_t piece) {
  Kernel kernel(settings, {.profile = profiles::Profile(ProfileKind::time_optimal)});
  std::vector<interp::Setpoint> ticks;
  std::size_t fed = 0;
  auto status = interp::TickStatus::running;
  while (status == interp::TickStatus::running) {
    while (fed < program.text.size() && kernel.plan()) {
      kernel.feed(std::string_view(program.text).substr(fed, piece));
      fed += piece;
    }
    if (fed >= program.text.size()) {
      kernel.finish();
    }
    status = kernel.next(ticks.emplace_back());
  }
  return ticks;
}

TEST(SmoothingPrograms, RunTheSameASecondTimeAndHoweverTheTextIsCut) {
  for (const std::uint64_t seed : {3U, 8U, 21U}) {
    const RandomProgram program = smoothing_program(seed);
    const MachineSettings settings = random_machine(seed, Spread::common);
    const auto once = smoothed_ticks_of(program, settings, 4096);
    for (const std::size_t piece : {std::size_t{4096}, std::size_t{17}}) {
      const auto again = smoothed_ticks_of(program, settings, piece);
      ASSERT_EQ(once.size(), again.size()) << seed;
      for (std::size_t i = 0; i < once.size(); ++i) {
        ASSERT_EQ(once[i].position_mm, again[i].position_mm) << seed << ", tick " << i;
        ASSERT_EQ(once[i].line, again[i].line) << seed << ", tick " << i;
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
