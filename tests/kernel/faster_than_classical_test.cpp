// The time optimum is never slower than a classical profile by more than a tick.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <utility>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "tests/kernel/degenerate_program.hpp"
#include "tests/kernel/printed_words.hpp"
#include "tests/kernel/random_machine.hpp"
#include "tests/kernel/singular_curves.hpp"
#include "tests/kernel/smooth_runs.hpp"

namespace kerf::test {
namespace {

constexpr std::array kRivals{ProfileKind::s_curve, ProfileKind::sigmoid, ProfileKind::sine,
                             ProfileKind::quintic, ProfileKind::sine_series};

void expect_no_slower(const SmoothRun& run, std::span<const ProfileKind> rivals) {
  const double time_s = plan_of(run).time_s;
  EXPECT_GT(time_s, 0.0) << run.name;
  for (const ProfileKind rival : rivals) {
    EXPECT_LE(time_s, plan_of(run, rival).time_s + 1.001 * run.settings.limits.period_s)
        << run.name << ", " << name_of(rival);
  }
}

void expect_no_slower(const SmoothRun& run, ProfileKind rival) {
  expect_no_slower(run, {&rival, 1});
}

TEST(TimeOptimum, IsNoSlowerThanAClassicalProfileOnRandomPrograms) {
  for (std::size_t i = 0; i < count_of(SmoothKind::random); i += 97) {
    expect_no_slower(smooth_run(SmoothKind::random, i), kRivals);
  }
}

TEST(TimeOptimum, IsNoSlowerThanTheSCurveOnTheShippedCurves) {
  for (std::size_t i = 0; i < count_of(SmoothKind::shipped); i += 41) {
    expect_no_slower(smooth_run(SmoothKind::shipped, i), ProfileKind::s_curve);
  }
}

// Limits along the path alone: the S-curve is the optimum there but for the bends.
TEST(TimeOptimum, IsNoSlowerThanTheSCurveUnderLimitsAlongThePath) {
  for (std::size_t i = 0; i < count_of(SmoothKind::shipped); i += 23) {
    SmoothRun run = smooth_run(SmoothKind::shipped, i);
    MachineLimits& limits = run.settings.limits;
    limits.path.acceleration_mm_s2 = limits.axes[0].acceleration_mm_s2;
    limits.path.jerk_mm_s3 = limits.axes[0].jerk_mm_s3;
    for (MotionLimits& axis : limits.axes) {
      axis.acceleration_mm_s2 = axis.jerk_mm_s3 = kUnbounded;
    }
    expect_no_slower(run, ProfileKind::s_curve);
  }
}

// Found by a soak: curves that rest within, or turn back within micrometres. The S-curve passed
// them in 81, 306 and 125 ms, the search in 95, 441 and 135. The fourth has 8 mm/s2 and takes ten
// seconds from apex to apex, which no window saw at once: 123 s and 105. On the last part of the
// fifth no search keeps the limits: 434 ms and 391. The last two turn back within nanometres, and
// nobody asked the S-curve: 10,122 ticks and 10,118, 532 and 530.
TEST(TimeOptimum, IsNoSlowerThanTheSCurveOnCurvesThatTurnBack) {
  for (const std::uint64_t seed : {228U, 243U, 363U, 30001875U, 32001402U, 70001571U, 70001604U}) {
    const SingularCase made = random_singular_case(seed, 20.0);
    SmoothRun run{.name = "seed " + std::to_string(seed),
                  .text = program_of(made.data, made.feedrate_mm_s),
                  .settings = {}};
    run.settings.limits = made.limits;
    expect_no_slower(run, ProfileKind::s_curve);
  }
}

// Found by a soak: no search from the curve's cusp on ended well for the sake of the first 60 of
// its 1,400 cells, and the rests that were put into it on the way to them stayed: 17.94 s
// and 17.21.
TEST(TimeOptimum, RestsOnceWhereASearchFailsCloseToItsBegin) {
  const std::uint64_t seed = 31015178;
  const SingularCase made = random_singular_case(seed, 20.0);
  SmoothRun run{.name = "seed " + std::to_string(seed),
                .text = "G64 P0.1\n" + program_of(made.data, made.feedrate_mm_s),
                .settings = {}};
  run.settings.limits = made.limits;
  expect_no_slower(run, ProfileKind::sigmoid);
}

// Found by a soak, each for a reason of its own: a rest within a curve lasted no tick where it was
// compared; rounding made a jump of curvature, which took its share of the jerk; only a part of a
// curve was planned without a degradation, and that was compared with nothing; nor were a line and
// such a part of the curve after it.
TEST(TimeOptimum, IsNoSlowerThanTheSCurveBesideMovesThatAreAsGoodAsNone) {
  for (const std::uint64_t seed : {9100860U, 9101106U, 9111841U, 9112308U, 60003872U}) {
    const SmoothRun run{.name = "seed " + std::to_string(seed),
                        .text = degenerate_program(seed).text,
                        .settings = random_machine(seed, Spread::common)};
    expect_no_slower(run, kRivals);
  }
}

// Found by a soak: the ticks that see a jump of curvature were taken to reach over all of a curve
// of micrometres, as if the tool passed it at the highest acceleration. The sigmoid passed them in
// 198 and 284 ms, the search in 207 and 297.
TEST(TimeOptimum, IsNoSlowerThanClassicalProfilesOnTinyCurvesWithJumpsOfCurvature) {
  for (const std::uint64_t seed : {65000193U, 65001738U}) {
    const SingularCase made = random_singular_case(seed, 20.0);
    SmoothRun run{.name = "seed " + std::to_string(seed),
                  .text = program_of(made.data, made.feedrate_mm_s),
                  .settings = {}};
    run.settings.limits = made.limits;
    expect_no_slower(run, kRivals);
  }
}

// Bezier curves of some tenths of a millimetre or some millimetres that join without a corner,
// their curvature with a jump, on a machine whose axes differ.
SmoothRun chain_of_curves(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto between = [&random](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  const auto spread = [&](double low, double high) {
    return low * std::pow(high / low, between(0, 1));
  };
  SmoothRun run{.name = "chain " + std::to_string(seed), .text = {}, .settings = default_machine()};
  auto& limits = run.settings.limits;
  limits.period_s = 0.001 * static_cast<double>(1 << static_cast<int>(between(0.0, 2.999)));
  limits.path.acceleration_mm_s2 = spread(500.0, 6000.0);
  limits.path.jerk_mm_s3 = spread(2e4, 6e5);
  for (MotionLimits& axis : limits.axes) {
    axis = {.velocity_mm_s = spread(20.0, 400.0),
            .acceleration_mm_s2 = spread(300.0, 6000.0),
            .jerk_mm_s3 = spread(1.5e4, 6e5)};
  }
  run.text = "G21 G90 G61 F" + std::to_string(spread(500.0, 9000.0)) + "\n";
  Eigen::Vector2d at(0.0, 0.0);
  double heading_rad = between(0.0, 2.0 * std::numbers::pi);
  const auto along = [](double rad) { return Eigen::Vector2d(std::cos(rad), std::sin(rad)); };
  for (int curves = 3 + static_cast<int>(between(0.0, 12.0)); curves > 0; --curves) {
    const double next_rad = heading_rad + between(-0.8, 0.8);
    const double length_mm = spread(0.2, 3.0);
    at += length_mm * along(0.5 * (heading_rad + next_rad));
    const Eigen::Vector2d first = between(0.15, 0.45) * length_mm * along(heading_rad);
    const Eigen::Vector2d last = between(0.15, 0.45) * length_mm * along(next_rad);
    run.text += "G5";
    for (const auto& [letter, number] :
         {std::pair{'X', at.x()}, std::pair{'Y', at.y()}, std::pair{'I', first.x()},
          std::pair{'J', first.y()}, std::pair{'P', -last.x()}, std::pair{'Q', -last.y()}}) {
      run.text += letter;
      print_number(number, run.text);
    }
    run.text += '\n';
    heading_rad = next_rad;
  }
  run.text += "M2\n";
  return run;
}

// Found with a client: where the search ends badly the S-curve stands in, and it was up to a fifth
// slower than the sine: it parted a curve in which it should not rest, came nearly to rest at a
// joint for the sake of its feedrate before it, and nobody asked the other profiles.
TEST(TimeOptimum, IsNoSlowerThanAClassicalProfileOnChainsOfShortCurves) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    expect_no_slower(chain_of_curves(seed), kRivals);
  }
}

// Found by reading: the barriers of the search took a part of the time, which at a low feedrate was
// 5 to 1,000 ticks.
TEST(TimeOptimum, IsNoSlowerAtLowFeedrates) {
  for (const int feed_mm_min : {20, 60, 200, 600}) {
    const std::string begin = "G21 G90 G64 P0.01 F" + std::to_string(feed_mm_min) + "\n";
    for (const char* path : {"G1 X30\nY30\nM2\n", "G1 X400\nY400\nM2\n",
                             "G1 X30 Y1\nX60\nG2 X70 Y-10 R10\nG1 X90 Y-60\nX91\nX92 Y5\nM2\n"}) {
      expect_no_slower({.name = begin + path, .text = begin + path, .settings = default_machine()},
                       kRivals);
    }
  }
}

std::string zigzag(std::size_t lines) {
  std::string text = "G21 G90 G61 F6000\n";
  for (std::size_t i = 1; i <= lines; ++i) {
    text += "G1 X" + std::to_string(0.5 * static_cast<double>(i)) + " Y" +
            std::to_string(0.04 * static_cast<double>(i % 2)) + "\n";
  }
  return text + "M2\n";
}

// Exact corners, far more of them than the window holds: each is passed as the S-curve passes it.
TEST(TimeOptimum, PassesExactCornersOfAnyNumberAsTheSCurveDoes) {
  for (const std::size_t lines : {2U, 40U, 3000U}) {
    const SmoothRun run{
        .name = std::to_string(lines), .text = zigzag(lines), .settings = default_machine()};
    EXPECT_EQ(plan_of(run).time_s, plan_of(run, ProfileKind::s_curve).time_s) << run.name;
  }
}

// Corners, and then an arc that joins the last line without one: the arc makes cells of all lines.
TEST(TimeOptimum, IsNoSlowerWhereCornersAndSmoothJunctionsTakeTurns) {
  std::string text = "G21 G90 G61 F6000\n";
  for (int i = 0; i < 300; ++i) {
    const std::string x = std::to_string(2.0 * i);
    text +=
        i % 7 == 6 ? "G2 X" + x + " Y0.01 R3\n" : "G1 X" + x + " Y" + std::to_string(i % 2) + "\n";
  }
  const SmoothRun run{
      .name = "corners and arcs", .text = text + "M2\n", .settings = default_machine()};
  expect_no_slower(run, ProfileKind::s_curve);
}

// Blends so short that the third derivative changes by all of itself within a cell: the cells are
// halved, and the search goes on from a plan that is worse at first.
TEST(TimeOptimum, IsFoundAroundBlendsOfShortArcs) {
  const SmoothRun run{.name = "arcs",
                      .text =
                          "G21 G64 P0.01\nG1 X10 Y10 F250\nY50\nX40\nG2 X50 Y40 J-10\nG1 Y20\n"
                          "G2 X40 Y10 I-10\nG1 X10\nM2\n",
                      .settings = default_machine()};
  EXPECT_EQ(plan_of(run).degradations.count, 0U);
}

// Over the short line the S-curve is faster than the search, from rest to rest. Over the arc, with
// constants for all of it, it is much slower.
TEST(TimeOptimum, FollowsNoSCurveFromAShortLineOntoAnArc) {
  MachineSettings settings = default_machine();
  settings.limits.path = {.velocity_mm_s = 1e6, .acceleration_mm_s2 = 1e9, .jerk_mm_s3 = 1e12};
  settings.limits.axes = {
      MotionLimits{.velocity_mm_s = 1000, .acceleration_mm_s2 = 46000, .jerk_mm_s3 = 566},
      MotionLimits{.velocity_mm_s = 4100, .acceleration_mm_s2 = 199000, .jerk_mm_s3 = 333000},
      MotionLimits{.velocity_mm_s = 17, .acceleration_mm_s2 = 41500, .jerk_mm_s3 = 32800}};
  const SmoothRun run{.name = "a line and an arc",
                      .text =
                          "G21 G90 G61 F45000\nG0 X0.0011617 Y0.0092878 Z0.0000868\n"
                          "G18 G3 X-0.9075283 Y-12.0396038 Z2.403222 I-5.0421564 K-0.5332072\nM2\n",
                      .settings = settings};
  expect_no_slower(run, kRivals);
}

// The acceleration of x binds on nearly all of the way, and the search is slower by 0.8 %. Before
// its plan ends the S-curve leads, but would lose that where it comes to rest.
TEST(TimeOptimum, FollowsTheSCurveWhereItLeadsOnLinesThatGoOn) {
  SmoothRun run{.name = "wavy lines", .text = "G21 G90 G61 F700\n", .settings = default_machine()};
  run.settings.limits.axes[0].acceleration_mm_s2 = 29.0;
  for (MotionLimits& axis : run.settings.limits.axes) {
    axis.jerk_mm_s3 = 1e5;
  }
  for (int i = 1; i <= 60; ++i) {
    const double angle_rad = 0.13 * i;
    run.text += "G1 X" + std::to_string(0.45 * i) + " Y" +
                std::to_string(0.5 * std::sin(angle_rad)) + " Z" +
                std::to_string(0.5 * std::cos(2.0 * angle_rad) - 0.5) + "\n";
  }
  run.text += "M2\n";
  expect_no_slower(run, ProfileKind::s_curve);
}

}  // namespace
}  // namespace kerf::test
