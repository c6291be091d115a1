#include "programs/kerf/report/summary.hpp"

#include <string>

#include <gtest/gtest.h>

#include "tests/program/sample_report.hpp"

namespace kerf::program {
namespace {

TEST(Summary, SaysWhatAMachinistReadsAtAGlance) {
  EXPECT_EQ(summary(sample_report()),
            "wing.ngc: done\n"
            "  cycle time      0:00:04.449   4449 ticks of 1 ms, s-curve\n"
            "  path            383.123 mm in 1 block\n"
            "  extents         x 0.000 to 100.000, y -2.000 to 65.667, z 0.000 to 5.000 mm\n"
            "  largest         velocity mm/s     acceleration mm/s2      jerk mm/s3\n"
            "    path          100    50 %           3000   100 %          55000   100 %\n"
            "    x              99    99 %           2900       -         1.24e6  2255 %\n"
            "    y              98    98 %           2800       -          54000    98 %\n"
            "    z               0     0 %              0       -              0     0 %\n"
            "  chord error     0.000250 mm, 50 % of 0.0005 mm\n"
            "  contour error   0.020000 mm at most, 0.004000 mm in the mean\n"
            "  following error x 0.0300, y 0.0250, z 0.0000 mm at most\n");
}

TEST(Summary, SaysWhatHoldsTheFeedDownWhereThatIsAskedFor) {
  FileReport report = sample_report();
  report.speed =
      SpeedReport{.whole = {.line = 0,
                            .ticks = 4000,
                            .limits = {{Constraint::programmed, 3000}, {Constraint::x_jerk, 1000}}},
                  .stops = 3,
                  .lines = {{.line = 12, .ticks = 1000, .limits = {{Constraint::x_jerk, 1000}}}},
                  .tick = {},
                  .each_line = {}};
  const std::string text = summary(report);
  EXPECT_NE(text.find("  limited by\n"
                      "    programmed feedrate         3.000 s   75.0 %\n"
                      "    axis x jerk                 1.000 s   25.0 %\n"
                      "  comes to rest   3 times\n"
                      "  lines that take the longest\n"
                      "    line 12           1.000 s   25.0 %   axis x jerk 100 %\n"),
            std::string::npos)
      << text;
  report.speed_question.line = 13;
  report.speed->lines.clear();
  EXPECT_NE(summary(report).find("  line 13 takes no time\n"), std::string::npos);
}

TEST(Summary, SaysWhereThePathIsFarthestFromTheProgrammedOne) {
  FileReport report = sample_report();
  report.plan->deviation = {.distance_mm = 0.0123456,
                            .at_mm = {19.9912, -0.00001, 2.0},
                            .line = 14,
                            .tolerance_mm = 0.05};
  EXPECT_NE(
      summary(report).find(
          "  extents         x 0.000 to 100.000, y -2.000 to 65.667, z 0.000 to 5.000 mm\n"
          "  deviation       0.012346 mm, 25 % of 0.05 mm, line 14, x 19.991, y 0.000, z 2.000 "
          "mm\n"),
      std::string::npos)
      << summary(report);
  report.plan->deviation.distance_mm = 1e-12;  // lines that were merged into a line
  EXPECT_EQ(summary(report), summary(sample_report()));
}

TEST(Summary, EndsWithTheWarnings) {
  FileReport report = sample_report();
  report.warnings = {"first", "second"};
  const std::string text = summary(report);
  EXPECT_NE(text.find("  warning         first\n  warning         second\n"), std::string::npos);
}

TEST(Summary, SaysThatARunWasStopped) {
  FileReport report = sample_report();
  report.status = ExitStatus::interrupted;
  EXPECT_EQ(summary(report).rfind("wing.ngc: stopped on the path, as asked for\n", 0), 0U);
  report.status = ExitStatus::machine_fault;
  EXPECT_EQ(summary(report).rfind("wing.ngc: stopped by a fault of the machine\n", 0), 0U);
}

TEST(Summary, CountsLateTicksOfARunInRealTime) {
  FileReport report = sample_report();
  report.clock = ClockReport{.late_ticks = 3, .worst_delay_s = 0.0012};
  EXPECT_NE(summary(report).find("clock           3 late ticks, the worst delay 1.200 ms"),
            std::string::npos);
}

TEST(Summary, OfAProgramWithErrorsIsNothing) {
  FileReport report = sample_report();
  report.plan.reset();
  report.motion.reset();
  EXPECT_EQ(summary(report), "");
}

TEST(Summary, OfACheckIsOneLine) {
  FileReport report = sample_report();
  report.command = Subcommand::check;
  report.motion.reset();
  EXPECT_EQ(summary(report),
            "wing.ngc: ok, 0:00:04.449, 383.123 mm in 1 block, "
            "x 0.000 to 100.000, y -2.000 to 65.667, z 0.000 to 5.000 mm\n");
}

TEST(Summary, TellsOfTheFurtherAxesOfTheMachine) {
  FileReport report = sample_report();
  report.extra_axes = parser::letters('A', 'U');
  report.plan->extra_extents.max_rad_mm = {3.14159265358979323846 / 2, 0, 0, 4.0, 0, 0};
  report.motion->extra[0] = {.v_mm_s = 1.0};
  report.limits.extra[0] = {.velocity_mm_s = 2.0};
  const std::string text = summary(report);
  EXPECT_NE(text.find("z 0.000 to 5.000 mm, a 0.000 to 90.000 deg, u 0.000 to 4.000 mm\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("    a         57.2958    50 %"), std::string::npos) << text;
  EXPECT_NE(text.find("in degrees\n"), std::string::npos) << text;
}

TEST(LimitUse, SaysByHowMuchALimitIsExceeded) {
  const LimitUse use{
      .where = "x", .quantity = "jerk", .unit = "mm/s3", .peak = 1.24e6, .limit = 55e3};
  EXPECT_EQ(describe(use), "axis x jerk 1.24e6 mm/s3 is 22.5 times its limit of 55000 mm/s3");
  EXPECT_TRUE(use.is_exceeded());
}

TEST(Summary, SaysWhereTheTimeOptimumWasNotFound) {
  PlanDegradations degradations;
  EXPECT_TRUE(describe(degradations).empty());
  degradations.count = 10;
  degradations.first.fill({.line = 9, .s_mm = 2.0, .kind = PlanDegradation::Kind::slower});
  degradations.first[0] = {.line = 7, .s_mm = 1.5, .kind = PlanDegradation::Kind::stop};
  const std::vector<std::string> warnings = describe(degradations);
  ASSERT_EQ(warnings.size(), 9U);
  EXPECT_EQ(warnings[0],
            "the time optimum was not found within its budget on line 7: the motion stops 1.500000 "
            "mm from the curve's begin");
  EXPECT_EQ(warnings[1],
            "the time optimum was not found within its budget on line 9: the motion is slower than "
            "it could be from 2.000000 mm on, up to its next stop");
  EXPECT_EQ(warnings[8], "the time optimum was not found at 2 more places");
}

TEST(Summary, SaysWhereAClassicalPlanStandsIn) {
  PlanDegradations degradations;
  degradations.count = 1;
  degradations.first[0] = {.line = 4, .s_mm = 0.0, .kind = PlanDegradation::Kind::classical};
  EXPECT_EQ(describe(degradations).front(),
            "the time optimum was not found within its budget on line 4: the motion follows a "
            "classical profile's plan from 0.000000 mm on, up to its next stop");
}

TEST(LimitUse, AllowsForRoundingAndForLimitsThatAreNone) {
  EXPECT_FALSE((LimitUse{.peak = 100.4, .limit = 100.0}.is_exceeded()));
  EXPECT_TRUE((LimitUse{.peak = 100.6, .limit = 100.0}.is_exceeded()));
  EXPECT_FALSE((LimitUse{.peak = 1e300, .limit = lookahead::kUnbounded}.is_exceeded()));
}

TEST(LimitUse, ComesForThePathAndEachAxisInOrder) {
  const FileReport report = sample_report();
  const auto uses = limit_uses(*report.motion, report.limits);
  EXPECT_EQ(uses[0].where, "path");
  EXPECT_EQ(uses[0].peak, 100.0);
  EXPECT_EQ(uses[0].limit, 200.0);
  EXPECT_EQ(uses[5].where, "x");
  EXPECT_EQ(uses[5].quantity, "jerk");
  EXPECT_EQ(uses[5].peak, 1.24e6);
  EXPECT_EQ(uses[11].where, "z");
}

}  // namespace
}  // namespace kerf::program
