#include "programs/kerf/compare/comparison.hpp"

#include <gtest/gtest.h>

#include "programs/kerf/compare/comparison_text.hpp"

namespace kerf::program {
namespace {

// Each of `times` in a run of its own.
FileReport report_of(const std::vector<LineLimitTime>& times, double period_s = 0.001) {
  FileReport report;
  report.file = "part.ngc";
  report.machine = "default";
  report.period_s = period_s;
  SpeedAccount account({.each_line = true}, period_s);
  TimeSplit split;
  std::int64_t tick = 0;
  for (const LineLimitTime& time : times) {
    account.add({.tick = tick, .line = time.line, .limit = time.limit});
    tick += time.ticks;
    (time.limit == Constraint::rest ? split.rest : split.cutting) += time.ticks;
  }
  account.add({.tick = tick, .line = times.back().line, .limit = times.back().limit});
  report.speed = account.report();
  report.plan = PlanReport{.cycle_time_s = static_cast<double>(tick) * period_s, .ticks = tick};
  report.motion = MotionReport{.time = split};
  return report;
}

TEST(Comparison, NamesTheLinesThatDifferMostWithTheirLimits) {
  const FileReport before = report_of({{1, Constraint::programmed, 100},
                                       {2, Constraint::path_jerk, 300},
                                       {2, Constraint::programmed, 100},
                                       {3, Constraint::programmed, 50}});
  const FileReport after = report_of({{1, Constraint::programmed, 110},
                                      {2, Constraint::programmed, 250},
                                      {3, Constraint::programmed, 50},
                                      {4, Constraint::rest, 40}});
  const std::string first = "G1 X1\nX2 F100\nX3\n";
  const std::string second = "G1 X1\nX2 F200\nX3\nG4 P0.04\n";
  const Comparison comparison = compare_programs({before, first}, {after, second}, 2);
  EXPECT_NEAR(difference_s(comparison.cycle_s), -0.1, 1e-12);
  EXPECT_NEAR(difference_s(comparison.cutting_s), -0.14, 1e-12);
  EXPECT_NEAR(difference_s(comparison.rest_s), 0.04, 1e-12);
  ASSERT_EQ(comparison.lines.size(), 2U);
  const LineDifference& changed = comparison.lines[0];
  EXPECT_EQ(changed.lines[0].text, "X2 F100");
  EXPECT_EQ(changed.lines[1].text, "X2 F200");
  EXPECT_NEAR(changed.times_s[0], 0.4, 1e-12);
  EXPECT_NEAR(changed.times_s[1], 0.25, 1e-12);
  ASSERT_EQ(changed.lines[0].limits.size(), 2U);
  EXPECT_EQ(changed.lines[0].limits[0].limit, Constraint::path_jerk);
  EXPECT_NEAR(changed.lines[0].limits[0].time_s, 0.3, 1e-12);
  EXPECT_TRUE(comparison.lines[1].lines[0].span.is_empty());
  EXPECT_EQ(comparison.lines[1].lines[1].span.first, 4U);
  EXPECT_EQ(comparison.other_lines, 1U);
  EXPECT_NEAR(comparison.other_lines_s, 0.01, 1e-12);
  ASSERT_EQ(comparison.limits.size(), 3U);
  EXPECT_EQ(comparison.limits[0].limit, Constraint::path_jerk);
  EXPECT_NEAR(difference_s(comparison.limits[0].times_s), -0.3, 1e-12);
}

TEST(Comparison, CountsTimesOfMachinesWithOtherPeriods) {
  const std::string text = "G1 X1\n";
  const FileReport slow = report_of({{1, Constraint::programmed, 100}}, 0.004);
  const FileReport quick = report_of({{1, Constraint::programmed, 500}}, 0.001);
  const Comparison comparison = compare_programs({slow, text}, {quick, text}, 5);
  ASSERT_EQ(comparison.lines.size(), 1U);
  EXPECT_NEAR(difference_s(comparison.lines[0].times_s), 0.1, 1e-12);
  EXPECT_NEAR(difference_s(comparison.limits[0].times_s), 0.1, 1e-12);
}

TEST(Comparison, TellsLinesOfOtherFilesByTheirNumbers) {
  const std::string text = "o<hole> call\n";
  const FileReport before =
      report_of({{1, Constraint::programmed, 10}, {7, Constraint::programmed, 30}});
  const FileReport after =
      report_of({{1, Constraint::programmed, 10}, {7, Constraint::programmed, 20}});
  const Comparison comparison = compare_programs({before, text}, {after, text}, 5);
  ASSERT_EQ(comparison.lines.size(), 1U);
  EXPECT_EQ(comparison.lines[0].lines[0].span.first, 7U);
  EXPECT_EQ(comparison.lines[0].lines[1].span.first, 7U);
  EXPECT_EQ(comparison.lines[0].lines[0].text, "");
}

TEST(Comparison, SaysSoWhereNothingDiffers) {
  const std::string text = "G1 X1\n";
  const FileReport report = report_of({{1, Constraint::programmed, 100}});
  const Comparison comparison = compare_programs({report, text}, {report, text}, 5);
  const std::string words =
      comparison_text({.first = report, .second = report, .comparison = &comparison});
  EXPECT_NE(words.find("difference      0.000 s, +0.0 %"), std::string::npos) << words;
  EXPECT_NE(words.find("each line takes the same time in both"), std::string::npos) << words;
}

TEST(Comparison, ShowsNoControlCharactersOfAProgram) {
  const std::string first = "G1 X1 (\x1b[2J)\n";
  const std::string second = "G1 X2 (\x1b[2J)\n";
  const FileReport before = report_of({{1, Constraint::programmed, 100}});
  const FileReport after = report_of({{1, Constraint::programmed, 120}});
  const Comparison comparison = compare_programs({before, first}, {after, second}, 5);
  const ComparedReports compared{.first = before, .second = after, .comparison = &comparison};
  EXPECT_EQ(comparison_text(compared).find('\x1b'), std::string::npos);
  EXPECT_EQ(comparison_json(compared, ExitStatus::done).find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace kerf::program
