// Random programs stopped at a random tick: every limit at every tick, and rest at the end.
#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "profiles/profile.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

struct Trial {
  std::uint64_t seed = 0;
  ProfileKind kind = ProfileKind::s_curve;
  std::size_t window_blocks = 1000;
  std::int64_t stop_tick = -1;  // none
};

struct StopOutcome {
  std::string complaint;
  interp::Setpoint last{};
};

constexpr std::int64_t kMostTicks = 100'000;

StopOutcome run(const RandomProgram& program, const Trial& trial) {
  const MachineSettings settings = mill();
  Kernel kernel(settings, {.profile = Profile(trial.kind), .window_blocks = trial.window_blocks});
  kernel.feed(program.text);
  kernel.finish();
  TickChecker checker(settings.limits, trial.kind != ProfileKind::trapezoid);
  StopOutcome outcome;
  std::size_t line_before = 1;
  auto status = interp::TickStatus::running;
  for (std::int64_t i = 0; status == interp::TickStatus::running && i < kMostTicks; ++i) {
    if (i == trial.stop_tick) {
      kernel.stop();
    }
    status = kernel.next(outcome.last);
    const std::size_t line = std::clamp<std::size_t>(outcome.last.line, 1, program.lines());
    checker.add(
        {.setpoint = outcome.last, .feedrate_mm_s = program.fastest_mm_s(line_before, line)});
    line_before = line;
  }
  outcome.complaint = checker.complaint();
  if (status == interp::TickStatus::starved) {
    outcome.complaint += " starved";
  }
  outcome.complaint += kernel.fault() ? " " + kernel.fault()->what : "";
  if (status == interp::TickStatus::finished && outcome.last.v_mm_s != 0.0) {
    outcome.complaint += " finished in motion";
  }
  return outcome;
}

std::string describe(const Trial& trial) {
  return "seed " + std::to_string(trial.seed) + ", " + std::string(profiles::name_of(trial.kind)) +
         ", window " + std::to_string(trial.window_blocks) + ", stop at " +
         std::to_string(trial.stop_tick);
}

constexpr std::uint64_t kTrials = 600;

TEST(RandomPrograms, KeepEveryLimitWhenStopped) {
  for (std::uint64_t seed = 1; seed <= kTrials && !HasFailure(); ++seed) {
    std::mt19937_64 random(seed);
    const Trial trial{.seed = seed,
                      .kind = static_cast<ProfileKind>(seed % 7),
                      .window_blocks = seed % 2 == 0 ? 1000U : 3U,
                      .stop_tick = static_cast<std::int64_t>(
                          std::exp(std::uniform_real_distribution<>(0.0, 8.5)(random)))};
    SCOPED_TRACE(describe(trial));
    const RandomProgram program =
        random_program(seed, {.arcs = seed % 3 != 0, .nurbs = seed % 4 == 1, .blocks = 8});
    EXPECT_EQ(run(program, trial).complaint, "") << program.text;
  }
}

}  // namespace
}  // namespace kerf::test
