#include "programs/kerf/report/json_report.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "diagnostics/errors/pages.hpp"
#include "tests/program/sample_report.hpp"

namespace kerf::program {
namespace {

using nlohmann::json;

TEST(JsonReport, IsOneLineWithTheFiguresAsNumbers) {
  const std::string text = json_report(sample_report());
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  const json report = json::parse(text);
  EXPECT_EQ(report["schema_version"], kJsonSchemaVersion);
  EXPECT_EQ(report["file"], "wing.ngc");
  EXPECT_EQ(report["exit_status"], 0);
  EXPECT_EQ(report["cycle_time_s"], 4.449);
  EXPECT_EQ(report["ticks"], 4449);
  EXPECT_EQ(report["path_length_mm"], 383.1234);
  EXPECT_EQ(report["blocks"], 1);
  EXPECT_EQ(report["max"]["path"]["j_mm_s3"], 55e3);
  EXPECT_EQ(report["max"]["axes"]["x"]["j_mm_s3"], 1.24e6);
  EXPECT_EQ(report["extents"]["max_mm"]["x"], 100.0);
  EXPECT_EQ(report["contour_error"]["mean_mm"], 0.004);
  EXPECT_TRUE(report["warnings"].is_array());
  EXPECT_FALSE(report.contains("late_ticks"));
}

TEST(JsonReport, HasTheFurtherAxesOfTheMachineInTheirUnits) {
  FileReport report = sample_report();
  EXPECT_FALSE(json::parse(json_report(report))["max"]["axes"].contains("a"));
  report.extra_axes = parser::letters('A', 'W');
  report.plan->extra_extents.max_rad_mm = {3.14159265358979323846, 0, 0, 0, 0, 7.0};
  report.motion->extra[0] = {.v_mm_s = 1.0, .a_mm_s2 = 2.0, .j_mm_s3 = 3.0};
  report.motion->extra[5] = {.v_mm_s = 11.0};
  report.limits.extra[5] = {.velocity_mm_s = 10.0};
  const json parsed = json::parse(json_report(report));
  EXPECT_EQ(parsed["extents"]["max_deg"]["a"], 180.0);
  EXPECT_EQ(parsed["extents"]["min_deg"]["a"], 0.0);
  EXPECT_EQ(parsed["extents"]["max_mm"]["w"], 7.0);
  EXPECT_FALSE(parsed["extents"]["max_mm"].contains("u"));
  EXPECT_NEAR(parsed["max"]["axes"]["a"]["j_deg_s3"].get<double>(), 171.887, 1e-3);
  EXPECT_EQ(parsed["max"]["axes"]["w"]["v_mm_s"], 11.0);
  EXPECT_EQ(parsed["limits_exceeded"][1]["where"], "w");
}

TEST(JsonReport, HasTheDeviationFromTheProgrammedPath) {
  FileReport report = sample_report();
  EXPECT_EQ(json::parse(json_report(report))["deviation"], json::parse(R"({"max_mm": 0.0})"));
  report.plan->deviation = {
      .distance_mm = 0.0125, .at_mm = {19.5, 0.25, -2.0}, .line = 14, .tolerance_mm = 0.05};
  EXPECT_EQ(json::parse(json_report(report))["deviation"],
            json::parse(R"({"max_mm": 0.0125, "tolerance_mm": 0.05, "line": 14,
                            "at_mm": {"x": 19.5, "y": 0.25, "z": -2.0}})"));
}

TEST(JsonReport, HasWhatHoldsTheFeedDownWhereThatIsAskedFor) {
  FileReport report = sample_report();
  EXPECT_FALSE(json::parse(json_report(report)).contains("speed_limits"));
  const LineSpeed line{.line = 12, .ticks = 4, .limits = {{Constraint::x_jerk, 4}}};
  report.speed = SpeedReport{
      .whole = {.line = 0,
                .ticks = 16,
                .limits = {{Constraint::programmed, 12}, {Constraint::x_jerk, 4}}},
      .stops = 2,
      .lines = {line},
      .tick = TickSpeed{.tick = 500, .line = 12, .v_mm_s = 9.5, .limit = Constraint::x_jerk},
      .each_line = {}};
  const json parsed = json::parse(json_report(report));
  EXPECT_EQ(parsed["speed_limits"]["programmed_feedrate"]["share"], 0.75);
  EXPECT_EQ(parsed["speed_limits"]["axis_x_jerk"]["time_s"], 0.004);
  EXPECT_EQ(parsed["stops"], 2);
  EXPECT_EQ(parsed["speed_limits_of_lines"][0]["line"], 12);
  EXPECT_EQ(parsed["speed_limits_of_lines"][0]["limits"]["axis_x_jerk"]["share"], 1.0);
  EXPECT_EQ(parsed["speed_limit_at"]["limit"], "axis_x_jerk");
  EXPECT_EQ(parsed["speed_limit_at"]["t_s"], 0.5);
}

TEST(JsonReport, NamesTheLimitsThatAreExceeded) {
  const json report = json::parse(json_report(sample_report()));
  ASSERT_EQ(report["limits_exceeded"].size(), 1U);
  EXPECT_EQ(report["limits_exceeded"][0]["where"], "x");
  EXPECT_EQ(report["limits_exceeded"][0]["quantity"], "jerk");
  EXPECT_NEAR(report["limits_exceeded"][0]["ratio"].get<double>(), 1.24e6 / 55e3, 1e-9);
}

TEST(JsonReport, NeverHoldsWhatIsNoNumber) {
  FileReport report = sample_report();
  report.motion->chord_error_mm = std::numeric_limits<double>::quiet_NaN();
  report.motion->max_contour_error_mm = std::numeric_limits<double>::infinity();
  const json parsed = json::parse(json_report(report));
  EXPECT_TRUE(parsed["chord_error_mm"].is_null());
  EXPECT_TRUE(parsed["contour_error"]["max_mm"].is_null());
}

TEST(JsonReport, OfAProgramWithErrorsHasThemAndNoFigures) {
  FileReport report;
  report.file = "wrong.ngc";
  report.status = ExitStatus::program_error;
  report.diagnostics = {diagnostics::Diagnostic({3, 7}, errors::kUnknownGCode, "found G99")};
  report.failures = {"and the disk is full"};
  const json parsed = json::parse(json_report(report));
  EXPECT_EQ(parsed["exit_status"], 1);
  EXPECT_EQ(parsed["errors"][0]["line"], 3);
  EXPECT_EQ(parsed["errors"][0]["column"], 7);
  EXPECT_EQ(parsed["errors"][0]["message"], "found G99");
  EXPECT_EQ(parsed["errors"][0]["id"], "E0100");
  EXPECT_EQ(parsed["errors"][1]["message"], "and the disk is full");
  EXPECT_FALSE(parsed.contains("cycle_time_s"));
}

TEST(JsonReport, BearsAFileNameThatIsNotUtf8) {
  FileReport report = sample_report();
  report.file = "fr\xe4sen.ngc";
  EXPECT_EQ(json::parse(json_report(report))["file"], "fr\xef\xbf\xbdsen.ngc");
}

}  // namespace
}  // namespace kerf::program
