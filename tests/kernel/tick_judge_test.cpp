// Ticks that exceed a limit are found out, by figure, axis, line and tick.
#include "kernel/tick_judge.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace kerf {
namespace {

using ExcessFigure = TickExcess::Figure;

constexpr double kTs = 0.001;

lookahead::PlanLimits limits() {
  lookahead::PlanLimits limits{.period_s = kTs, .chord_tolerance_mm = 1e-3};
  limits.path = {.velocity_mm_s = 100.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 1e5};
  return limits;
}

// A motion of constant jerk along X, whose figures are known in closed form: the third difference
// of j t^3 / 6 is j Ts^3, the second a at the middle of three ticks.
TickJudge judge_of(double jerk_mm_s3, std::int64_t ticks, TickJudge::Settings settings) {
  TickJudge judge(settings);
  for (std::int64_t i = 0; i <= ticks; ++i) {
    interp::Setpoint setpoint;
    setpoint.tick = i;
    setpoint.line = 5;
    const double t = static_cast<double>(std::max<std::int64_t>(i - 3, 0)) * kTs;
    setpoint.s_mm = setpoint.position_mm[0] = jerk_mm_s3 * t * t * t / 6.0;
    judge.add(setpoint, 0.0);
  }
  return judge;
}

TEST(TickJudge, FindsNothingWhileAllHolds) {
  const TickJudge judge = judge_of(0.999e5, 10, {.limits = limits()});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::none);
  EXPECT_FALSE(describe(judge.excess()));
  EXPECT_NEAR(judge.path().j_mm_s3, 0.999e5, 1e-2);
}

TEST(TickJudge, FindsAJerkThatIsAPerMilleTooLarge) {
  const TickJudge judge = judge_of(1.001e5, 10, {.limits = limits()});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::jerk);
  EXPECT_EQ(judge.excess().axis, TickExcess::kPath);
  EXPECT_EQ(judge.excess().line, 5U);
  ASSERT_TRUE(describe(judge.excess()));
  EXPECT_EQ(describe(judge.excess())->line, 5U);
}

TEST(TickJudge, KnowsNoJerkWhereTheProfileKnowsNone) {
  const TickJudge judge = judge_of(1.001e5, 10, {.limits = limits(), .binds_jerk = false});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::none);
}

TEST(TickJudge, FindsTheFirstAccelerationThatIsTooLarge) {
  // The second difference at tick i is 1e5 (i - 4) Ts: 1000 at tick 14, more at 15.
  const TickJudge judge = judge_of(0.9999e5, 40, {.limits = limits()});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::acceleration);
  EXPECT_EQ(judge.excess().tick, 15);
}

TEST(TickJudge, FindsWhatOneAxisDoes) {
  lookahead::PlanLimits only_x;
  only_x.period_s = kTs;
  only_x.axes[0].velocity_mm_s = 1.0;
  const TickJudge judge = judge_of(1e5, 40, {.limits = only_x});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::velocity);
  EXPECT_EQ(judge.excess().axis, 0);
}

TEST(TickJudge, FindsANumberThatIsNone) {
  TickJudge judge({.limits = limits()});
  interp::Setpoint setpoint;
  judge.add(setpoint, 0.0);
  setpoint.position_mm[1] = std::nan("");
  judge.add(setpoint, 0.0);
  EXPECT_EQ(judge.excess().figure, ExcessFigure::not_finite);
  EXPECT_EQ(judge.excess().axis, 1);
}

TEST(TickJudge, FindsAChordThatLeavesThePathByMoreThanTheTolerance) {
  TickJudge judge({.limits = limits()});
  judge.add({}, 1.004e-3);
  EXPECT_EQ(judge.excess().figure, ExcessFigure::none);
  judge.add({}, 1.006e-3);
  EXPECT_EQ(judge.excess().figure, ExcessFigure::chord_error);
}

TEST(TickJudge, FindsAnEndThatIsNotTheProgrammedOne) {
  TickJudge judge({.limits = limits()});
  interp::Setpoint last;
  last.position_mm = {1.0, 2.0, 3.0};
  judge.judge_end(last, {.position_mm = {1.0, 2.0, 3.0 + 9e-11}});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::none);
  judge.judge_end(last, {.position_mm = {1.0, 2.0 + 2e-10, 3.0}});
  EXPECT_EQ(judge.excess().figure, ExcessFigure::end);
  EXPECT_EQ(judge.excess().axis, 1);
}

}  // namespace
}  // namespace kerf
