// Seeded random programs: every limit at every tick, every tick on the path, the chord between two
// ticks within the tolerance of it, the end where the program says, never a hang.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "kernel/kernel.hpp"
#include "tests/kernel/chord_checker.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

constexpr std::int64_t kMostTicks = 3'000'000;

// KERF_RANDOM_PROGRAMS and KERF_RANDOM_SEED override count and first seed.
std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
  const char* text = std::getenv(name);
  return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

MachineSettings machine_for(std::uint64_t seed) {
  MachineSettings settings;
  auto pick = [state = seed * 2654435761U + 1]() mutable {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) / 9007199254740992.0;
  };
  for (lookahead::MotionLimits& axis : settings.limits.axes) {
    axis = {.velocity_mm_s = 50.0 + 450.0 * pick(),
            .acceleration_mm_s2 = 500.0 * std::pow(20.0, pick()),
            .jerk_mm_s3 = 5e3 * std::pow(100.0, pick())};
  }
  if (pick() < 0.5) {
    settings.limits.path = {
        .velocity_mm_s = 400.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 6e4};
  }
  settings.limits.chord_tolerance_mm = 1e-5 * std::pow(1000.0, pick());
  settings.program.extra_axes = parser::letters('A', 'U');
  for (const std::size_t axis : {0U, 3U}) {
    settings.limits.extra[axis] = {.velocity_mm_s = 2.0 + 20.0 * pick(),
                                   .acceleration_mm_s2 = 20.0 * std::pow(20.0, pick()),
                                   .jerk_mm_s3 = 5e2 * std::pow(50.0, pick())};
  }
  return settings;
}

struct Outcome {
  std::string complaint;
  interp::Setpoint last{};
};

struct Way {
  ProfileKind kind = ProfileKind::s_curve;
  std::size_t window_blocks = 1000;
};

Outcome run(const RandomProgram& program, const MachineSettings& settings, const Way& way) {
  const ProfileKind kind = way.kind;
  Kernel kernel(settings, {.profile = Profile(kind), .window_blocks = way.window_blocks});
  kernel.feed(program.text);
  kernel.finish();
  TickChecker checker(settings.limits, kind != ProfileKind::trapezoid);
  ChordChecker chords(program.path, settings.limits.chord_tolerance_mm);
  Outcome outcome;
  std::size_t line_before = 1;
  for (auto status = interp::TickStatus::running; status == interp::TickStatus::running;) {
    status = kernel.next(outcome.last);
    const std::size_t line = std::clamp<std::size_t>(outcome.last.line, 1, program.lines());
    checker.add(
        {.setpoint = outcome.last, .feedrate_mm_s = program.fastest_mm_s(line_before, line)});
    chords.add(outcome.last, kernel.chord_error_mm());
    line_before = line;
    outcome.complaint = checker.complaint() + chords.complaint();
    if (outcome.complaint.empty() && checker.ticks() > kMostTicks) {
      outcome.complaint = "does not end";
    }
    if (!outcome.complaint.empty()) {
      return outcome;
    }
    if (status == interp::TickStatus::starved) {
      outcome.complaint = "starved";
    }
  }
  if (kernel.has_errors()) {
    outcome.complaint =
        kernel.diagnostics().empty() ? "error" : kernel.diagnostics().back().message;
  }
  return outcome;
}

void expect_clean(std::uint64_t seed, const Mix& mix, const Way& way) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", profile " +
               std::string(profiles::name_of(way.kind)) + ", window " +
               std::to_string(way.window_blocks));
  const RandomProgram program = random_program(seed, mix);
  const Outcome outcome = run(program, machine_for(seed), way);
  EXPECT_EQ(outcome.complaint, "") << program.text;
  EXPECT_EQ(outcome.last.position_mm, program.end_mm) << program.text;
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  EXPECT_EQ(outcome.last.extra_rad_mm[0], program.end_a_deg * kDegree) << program.text;
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
