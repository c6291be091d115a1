#include "programs/kerf/report/speed_account.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

struct Stretch {
  std::uint32_t line = 0;
  Constraint limit{};
  int ticks = 0;
  double v_mm_s = 10.0;
};

SpeedReport speed_report_of(const std::vector<Stretch>& stretches,
                            const SpeedQuestion& question = {}) {
  SpeedAccount account(question, 0.001);
  std::int64_t tick = 0;
  for (const Stretch& stretch : stretches) {
    for (int i = 0; i < stretch.ticks; ++i) {
      account.add({.tick = tick++,
                   .line = stretch.line,
                   .limit = stretch.limit,
                   .motion = {.v_mm_s = stretch.v_mm_s},
                   .detail = {.at_rest = stretch.v_mm_s == 0.0}});
    }
  }
  return account.report();
}

TEST(SpeedAccount, CountsPeriodsAndEndsWithTheLastTick) {
  const SpeedReport report = speed_report_of({{1, Constraint::path_jerk, 10},
                                              {1, Constraint::programmed, 30},
                                              {2, Constraint::programmed, 59},
                                              {2, Constraint::rest, 2}});
  EXPECT_EQ(report.whole.ticks, 100);
  ASSERT_EQ(report.whole.limits.size(), 3U);
  EXPECT_EQ(report.whole.limits[0].limit, Constraint::programmed);
  EXPECT_EQ(report.whole.limits[0].ticks, 89);
  EXPECT_EQ(report.whole.limits[2].ticks, 1) << "no period begins with the last tick";
  ASSERT_EQ(report.lines.size(), 2U);
  EXPECT_EQ(report.lines[0].line, 2U);
  EXPECT_EQ(report.lines[1].ticks, 40);
}

TEST(SpeedAccount, AddsUpALineThatRunsManyTimesAndShowsTheLongest) {
  std::vector<Stretch> stretches;
  for (int turn = 0; turn < 100; ++turn) {
    for (std::uint32_t line = 1; line <= 200; ++line) {
      stretches.push_back({line, Constraint::programmed, line == 7 ? 5 : 1});
      stretches.push_back({line, Constraint::junction, 1});
    }
  }
  const SpeedReport report = speed_report_of(stretches);
  EXPECT_EQ(report.whole.ticks, 100 * (200 * 2 + 4) - 1);
  ASSERT_EQ(report.lines.size(), 5U);
  EXPECT_EQ(report.lines[0].line, 7U);
  EXPECT_EQ(report.lines[0].ticks, 600);
}

TEST(SpeedAccount, AnswersForOneLineOrOneInstant) {
  const std::vector<Stretch> stretches{{1, Constraint::path_jerk, 10},
                                       {2, Constraint::junction, 10}};
  const SpeedReport of_line = speed_report_of(stretches, {.line = 1, .time_s = {}});
  ASSERT_EQ(of_line.lines.size(), 1U);
  EXPECT_EQ(of_line.lines[0].ticks, 10);
  EXPECT_TRUE(speed_report_of(stretches, {.line = 3, .time_s = {}}).lines.empty());
  const SpeedReport at = speed_report_of(stretches, {.line = {}, .time_s = 0.0121});
  ASSERT_TRUE(at.tick.has_value());
  EXPECT_EQ(at.tick->tick, 12);
  EXPECT_EQ(at.tick->line, 2U);
  EXPECT_EQ(at.tick->limit, Constraint::junction);
  EXPECT_FALSE(speed_report_of(stretches, {.line = {}, .time_s = 1.0}).tick.has_value());
}

TEST(SpeedAccount, CountsHowOftenTheMotionComesToRest) {
  const auto jerk = Constraint::path_jerk;
  EXPECT_EQ(
      speed_report_of({{1, jerk, 3}, {1, jerk, 1, 0.0}, {2, jerk, 3}, {2, jerk, 2, 0.0}}).stops, 2);
}

TEST(SpeedAccount, OfNothingIsEmpty) {
  EXPECT_EQ(speed_report_of({}).whole.ticks, 0);
  EXPECT_TRUE(speed_report_of({}).whole.limits.empty());
}

TEST(ConstraintText, GivesEachLimitANameOfItsOwn) {
  std::set<std::string_view> keys;
  for (std::size_t i = 0; i < interp::kConstraints; ++i) {
    keys.insert(key_of(static_cast<Constraint>(i)));
    EXPECT_EQ(colour_of(static_cast<Constraint>(i)).size(), 7U);
  }
  EXPECT_EQ(keys.size(), interp::kConstraints);
  EXPECT_EQ(text_of(interp::of_axis(Constraint::x_jerk, 1)), "axis y jerk");
  EXPECT_EQ(text_of(interp::of_axis(Constraint::x_velocity, 8)), "axis w velocity");
  EXPECT_EQ(key_of(interp::of_axis(Constraint::x_acceleration, 3)), "axis_a_acceleration");
}

TEST(SpeedQuestion, IsOfAllOfALineOrOfATime) {
  EXPECT_TRUE(speed_question("all").has_value());
  EXPECT_EQ(speed_question("14")->line, 14U);
  EXPECT_EQ(speed_question("@1.5")->time_s, 1.5);
  EXPECT_EQ(speed_question("@0")->time_s, 0.0);
  for (const char* wrong :
       {"", "0", "-1", "x", "14x", "@", "@-1", "@nan", "@inf", "1.5", "99999999999"}) {
    EXPECT_FALSE(speed_question(wrong).has_value()) << wrong;
  }
}

}  // namespace
}  // namespace kerf::program
