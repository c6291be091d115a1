// The time optimum on singular and on random curves: every limit at every tick, no hang, the end
// where the program says.
#include "tests/kernel/singular_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/environment.hpp"
#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

using interp::TickStatus;

struct CurveOutcome {
  std::string complaint;
  interp::Setpoint last{};
  std::int64_t ticks = 0;
  PlanDegradations degradations{};
};

struct Feed {
  double feedrate_mm_s = 0.0;
  std::int64_t max_ticks = 0;  // more are a hang
};

CurveOutcome run(const curves::NurbsData& data, const lookahead::PlanLimits& limits,
                 const Feed& feed) {
  MachineSettings settings;
  settings.limits = limits;
  Kernel kernel(settings, {.profile = profiles::Profile(profiles::ProfileKind::time_optimal),
                           .start_mm = data.points.front().position_mm});
  kernel.feed(program_of(data, feed.feedrate_mm_s));
  kernel.finish();
  TickChecker checker(limits, true);
  CurveOutcome outcome;
  double chord_mm = 0.0;
  TickStatus status = TickStatus::running;
  while (status == TickStatus::running && checker.ticks() < feed.max_ticks) {
    status = kernel.next(outcome.last);
    checker.add({.setpoint = outcome.last, .feedrate_mm_s = feed.feedrate_mm_s});
    chord_mm = std::max(chord_mm, kernel.chord_error_mm());
  }
  outcome.complaint = checker.complaint();
  outcome.ticks = checker.ticks();
  outcome.degradations = kernel.totals().degradations;
  if (chord_mm > limits.chord_tolerance_mm * (1.0 + 1e-6)) {
    outcome.complaint += "chord error " + std::to_string(chord_mm);
  }
  if (kernel.has_errors()) {
    outcome.complaint += kernel.diagnostics().back().message;
  } else if (status != TickStatus::finished) {
    outcome.complaint += "does not end";
  }
  return outcome;
}

// As precisely as the program's text says it.
void expect_at_end(const CurveOutcome& outcome, const curves::NurbsData& data) {
  const auto end = curves::vec(data.points.back().position_mm);
  EXPECT_LT((curves::vec(outcome.last.position_mm) - end).norm(), 1e-9);
}

lookahead::PlanLimits on_axes(const lookahead::MotionLimits& each, double chord_mm) {
  lookahead::PlanLimits limits;
  limits.path.velocity_mm_s = each.velocity_mm_s;
  limits.chord_tolerance_mm = chord_mm;
  limits.axes.fill({.velocity_mm_s = lookahead::kUnbounded,
                    .acceleration_mm_s2 = each.acceleration_mm_s2,
                    .jerk_mm_s3 = each.jerk_mm_s3});
  return limits;
}

class Singular : public testing::TestWithParam<SingularCurve> {};

TEST_P(Singular, CurvesAreRunAtTheOptimumWithoutALimitBroken) {
  const curves::NurbsData& data = GetParam().data;
  const std::vector<lookahead::PlanLimits> all{on_axes({100.0, 3000.0, 55e3}, 5e-4),
                                               on_axes({100.0, 1000.0, 20e3}, 1e-3),
                                               on_axes({200.0, 2000.0, 30e3}, 1e-3)};
  for (const lookahead::PlanLimits& limits : all) {
    SCOPED_TRACE(limits.axes[0].acceleration_mm_s2);
    const CurveOutcome outcome =
        run(data, limits, {.feedrate_mm_s = limits.path.velocity_mm_s, .max_ticks = 60'000});
    EXPECT_EQ(outcome.complaint, "");
    expect_at_end(outcome, data);
    EXPECT_EQ(outcome.degradations.count, 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Singular, testing::ValuesIn(singular_curves()),
                         [](const auto& instance) { return instance.param.name; });

// Through the apex the acceleration may stand while the motion turns back, so a near-cusp costs
// hardly more than a turn: coming to rest with the acceleration at 0, as at the cusp itself, takes
// A / J longer at the most on each side.
TEST(SingularCurves, ANearCuspIsNoSlowerThanAStopAtIt) {
  const lookahead::PlanLimits limits = on_axes({100.0, 3000.0, 55e3}, 5e-4);
  const auto ticks = [&limits](const std::string& name) {
    const auto& all = singular_curves();
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&name](const SingularCurve& c) { return c.name == name; });
    return run(found->data, limits, {.feedrate_mm_s = 100.0, .max_ticks = 60'000}).ticks;
  };
  const std::int64_t cusp = ticks("cusp");
  for (const char* name : {"crossing_1e_3", "crossing_1e_4", "crossing_1e_5", "crossing_1e_6"}) {
    EXPECT_LE(ticks(name), cusp + 5) << name;
    EXPECT_GE(ticks(name), cusp - 2 * 55) << name;
  }
}

void expect_to_end_under_every_profile(const std::string& text, double feedrate_mm_s,
                                       const MachineSettings& settings,
                                       const std::array<double, 3>& end_mm) {
  const auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  const RandomProgram program{.text = text,
                              .start_mm = {},
                              .end_mm = {},
                              .feedrate_mm_s = std::vector<double>(lines, feedrate_mm_s),
                              .path = {},
                              .dense = {}};
  for (int kind = 0; kind < 7; ++kind) {
    const JudgedRun outcome =
        judged_run(program, settings, {.kind = static_cast<profiles::ProfileKind>(kind)});
    EXPECT_EQ(outcome.complaint, "") << kind;
    EXPECT_EQ(outcome.last.position_mm, end_mm) << kind;
  }
}

// Turning at a low feedrate only: the highest that fits is a tiny share of the programmed one.
TEST(SingularCurves, ShortOnesEndUnderEveryProfile) {
  expect_to_end_under_every_profile(
      "G21 G90 G17 G94\nG6.2 P2 K0 X0 Y0 Z0 F9000\nK0 X0.000004 Y0.000003 Z0\nK1\nK1\nM2\n", 150.0,
      mill(), {4e-6, 3e-6, 0.0});
}

JudgedRun judged_case(std::uint64_t seed, profiles::ProfileKind kind, double longest_s = 500.0) {
  const SingularCase made = random_singular_case(seed, longest_s);
  MachineSettings settings;
  settings.limits = made.limits;
  return judged_run(curve_program(made), settings, {.kind = kind});
}

// The classical schedule draws straight lines between samples of what an axis' velocity allows.
TEST(SingularCurves, TheVelocityOfAnAxisHoldsBetweenSamples) {
  for (const std::uint64_t seed : {10143U, 10413U, 10431U, 10485U}) {
    EXPECT_EQ(judged_case(seed, profiles::ProfileKind::s_curve).complaint, "") << seed;
  }
}

// Found by a soak: a rest at the curve's begin gave the cells after it back what a jump within
// took.
TEST(SingularCurves, AJumpOfCurvatureKeepsItsShareWhereTheCurveBeginsAtRest) {
  EXPECT_EQ(judged_case(65000193, profiles::ProfileKind::time_optimal, 20.0).complaint, "");
}

// The sine series has its peaks of jerk near its ends, between instants that are looked at.
TEST(SingularCurves, TheJerkOfAnAxisHoldsAtThePeaksOfALaw) {
  EXPECT_EQ(judged_case(1003143, profiles::ProfileKind::sine_series, 60.0).complaint, "");
}

// A span that could not be joined but slowed down as a whole leaves in parts of its cruise, and
// ends no faster for that.
TEST(SingularCurves, TheVelocityOfAnAxisHoldsBehindALongCruise) {
  EXPECT_EQ(judged_case(51669, profiles::ProfileKind::sine).complaint, "");
}

// Features of nanometres at the beginning or end of a long curve hold up the classical schedule
// where they are, not for all of it.
TEST(SingularCurves, TinyFeaturesDoNotSlowTheRestDown) {
  struct Case {
    std::uint64_t seed;
    profiles::ProfileKind kind;
  };
  for (const auto& [seed, kind] :
       {Case{438, profiles::ProfileKind::s_curve}, Case{20070, profiles::ProfileKind::trapezoid},
        Case{21270, profiles::ProfileKind::s_curve}}) {
    const JudgedRun classical = judged_case(seed, kind);
    EXPECT_EQ(classical.complaint, "") << seed;
    const JudgedRun optimum = judged_case(seed, profiles::ProfileKind::time_optimal);
    EXPECT_LT(classical.ticks, 3 * optimum.ticks) << seed;
  }
}

// A curve of its own between corners may be nothing else, sharper at its begin than any tick.
TEST(SingularCurves, ThoseOfNanometresAloneTakeNoLonger) {
  const JudgedRun classical = judged_case(7155693, profiles::ProfileKind::sigmoid, 20.0);
  EXPECT_EQ(classical.complaint, "");
  const JudgedRun optimum = judged_case(7155693, profiles::ProfileKind::time_optimal, 20.0);
  EXPECT_LT(classical.ticks, 3 * optimum.ticks);
}

// Where braking for 280 mm ends at a turn of nanometres.
TEST(SingularCurves, TheAccelerationOfAnAxisHoldsAtTheFootOfALongRamp) {
  EXPECT_EQ(judged_case(4005279, profiles::ProfileKind::s_curve, 20.0).complaint, "");
}

// Where the braking has its corner within such a turn.
TEST(SingularCurves, TheAccelerationOfAnAxisHoldsAtTheCornersOfALaw) {
  for (const std::uint64_t seed : {7102095U, 7163487U}) {
    EXPECT_EQ(judged_case(seed, profiles::ProfileKind::s_curve, 20.0).complaint, "") << seed;
  }
}

// Which the tick's own acceleration would carry it past, whatever the feedrate is there.
TEST(SingularCurves, TheChordHoldsAtATurnWhoseFeedrateIsLessThanATicksAcceleration) {
  for (const std::uint64_t seed : {9008790U, 9057702U}) {
    EXPECT_EQ(judged_case(seed, profiles::ProfileKind::trapezoid, 20.0).complaint, "") << seed;
  }
}

// After a straight part whose pieces of the arc-length map are longer than a tick.
TEST(SingularCurves, ANeedleThatATickPassesOverIsSeenFromAfar) {
  for (const std::uint64_t seed : {91300374U, 12025062U}) {
    EXPECT_EQ(judged_case(seed, profiles::ProfileKind::trapezoid, 20.0).complaint, "") << seed;
  }
}

// Shorter than a ten millionth of a millimetre is each tick on it.
TEST(SingularCurves, ANeedleIsPassedWithinAToleranceOfAPicometre) {
  MachineSettings settings = mill();
  settings.limits.chord_tolerance_mm = 1e-9;
  settings.limits.period_s = 0.0003;
  expect_to_end_under_every_profile(
      "G61.1\nG6.2 P3 K0 X0 Y0 R1 F3000\nK0 X0 Y0 R1\nK0 X0 Y0.0000015 R1\nK1 X0.000019 Y0 R2\n"
      "K5 X0 Y0 R2\nK6\nK6\nK6\nM2\n",
      50.0, settings, {0.0, 0.0, 0.0});
}

// The highest cruise that fits is a ten thousandth of what is allowed, and its ends are lower yet.
TEST(SingularCurves, ACruiseIsFoundHoweverLow) {
  EXPECT_LT(judged_case(1009383, profiles::ProfileKind::s_curve, 60.0).ticks, 20'000);
}

// Beside a corner that is not quite one, the derivatives are rounding, with thousands of valleys
// within a tick's way: too many phases for the ring if each were cut at.
TEST(SingularCurves, RoundingBesideACornerDoesNotStarveTheMotion) {
  EXPECT_EQ(judged_case(741, profiles::ProfileKind::sine).complaint, "");
  EXPECT_EQ(judged_case(10791, profiles::ProfileKind::sine_series).complaint, "");
}

// A valley within an ulp of a curve's end, after a cruise that leaves in many parts: their rounded
// sum is beyond that end.
TEST(SingularCurves, ACruiseInPartsDoesNotPassTheEndOfItsCurve) {
  EXPECT_EQ(judged_case(201375, profiles::ProfileKind::s_curve, 20.0).complaint, "");
  EXPECT_EQ(judged_case(205725, profiles::ProfileKind::sigmoid, 20.0).complaint, "");
}

// Their derivatives are rounding, which no feedrate can be planned on.
TEST(SingularCurves, ThoseOnALineToTheirLastDigitRunAsLines) {
  for (const std::uint64_t seed : {1011190U, 52206U}) {
    for (const auto kind : {profiles::ProfileKind::sine_series, profiles::ProfileKind::quintic,
                            profiles::ProfileKind::time_optimal}) {
      const JudgedRun outcome = judged_case(seed, kind);
      EXPECT_EQ(outcome.complaint, "") << seed;
      EXPECT_EQ(outcome.degradations, 0U) << seed;
      EXPECT_LT(outcome.ticks, 1000) << seed;
    }
  }
}

// Limits of each axis spread over four decades, feedrates over eight.
TEST(SingularCurves, AtRandomAreRunWithoutALimitBroken) {
  const std::uint64_t count = from_environment("KERF_SINGULAR_CURVES", 60);
  const std::uint64_t first = from_environment("KERF_SINGULAR_SEED", 1);
  for (std::uint64_t seed = first; seed < first + count && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const SingularCase made = random_singular_case(seed);
    const CurveOutcome outcome =
        run(made.data, made.limits, {.feedrate_mm_s = made.feedrate_mm_s, .max_ticks = 2'000'000});
    EXPECT_EQ(outcome.complaint, "");
    expect_at_end(outcome, made.data);
  }
}

}  // namespace
}  // namespace kerf::test
