#include "programs/kerf/page/nominal_lines.hpp"

#include <cmath>
#include <cstddef>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "programs/kerf/run/session.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

// As a page is shown them before the program is planned.
std::vector<NominalLines::Line> nominal_lines(const std::string& text,
                                              const MachineSettings& machine,
                                              double feed_override = 1.0) {
  const TemporaryFolder folder;
  const auto file = folder / "program.ngc";
  std::ofstream(file) << text;
  PageRecord page;
  std::vector<NominalLines::Line> lines;
  page.show_path = [&](const FileReport& /*report*/) { lines = page.nominal.value().lines(); };
  Options options;
  options.command = Subcommand::report;
  options.quiet = true;
  options.feed_override = feed_override;
  process_file(file, options, machine, &page);
  return lines;
}

MachineSettings machine_of(const char* text) {
  return parse_machine_file(text).value();
}

MachineSettings slow_along_y() {
  return machine_of(
      "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 50000\n"
      "[axes.y]\nmax_velocity_mm_s = 5\nmax_acceleration_mm_s2 = 1000\nmax_jerk_mm_s3 = 50000\n");
}

TEST(NominalLines, TakeTheirLengthOverTheirFeedrate) {
  const auto lines = nominal_lines("G21 G90 G61\nG1 F600 X30\n\nG2 X50 I10\nM2\n", slow_along_y());
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_NEAR(lines[2].duration_s, 3.0, 1e-12);
  EXPECT_EQ(lines[3].duration_s, 0.0);
  EXPECT_NEAR(lines[4].duration_s, std::numbers::pi, 1e-9);
}

TEST(NominalLines, AreBoundByPathAndAxes) {
  const auto lines =
      nominal_lines("G21 G90 G61 G0 X50\nG1 F6000 Y30\nF60000 X0\nM2\n", slow_along_y());
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_NEAR(lines[1].duration_s, 0.5, 1e-12) << "a rapid";
  EXPECT_NEAR(lines[2].duration_s, 6.0, 1e-12) << "5 mm/s of Y";
  EXPECT_NEAR(lines[3].duration_s, 0.5, 1e-12) << "100 mm/s of the path";
}

TEST(NominalLines, CountADwellAndEachRoundOfALoop) {
  const auto lines = nominal_lines(
      "G21 G61 G1 F600\nG4 P1.5\no1 repeat [4]\nG91 X5\no1 endrepeat\nM2\n", slow_along_y());
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[2].duration_s, 1.5);
  EXPECT_NEAR(lines[4].duration_s, 2.0, 1e-12);
}

TEST(NominalLines, EndWhereTheirLastRoundDoes) {
  const auto lines = nominal_lines(
      "G21 G61 G1 F600 X3\no1 repeat [4]\nG91 X5\nY1\no1 endrepeat\nG4 P1\nM2\n", slow_along_y());
  ASSERT_EQ(lines.size(), 7U);
  EXPECT_NEAR(lines[1].end_mm, 3.0, 1e-12);
  EXPECT_NEAR(lines[3].end_mm, 26.0, 1e-12);
  EXPECT_NEAR(lines[4].end_mm, 27.0, 1e-12);
  EXPECT_NEAR(lines[6].end_mm, 27.0, 1e-12);
}

TEST(NominalLines, FollowTheFeedOverrideButForRapids) {
  const auto lines = nominal_lines("G21 G90 G61 G0 X50\nG1 F600 X30\nM2\n", slow_along_y(), 0.5);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(lines[1].duration_s, 0.5, 1e-12);
  EXPECT_NEAR(lines[2].duration_s, 4.0, 1e-12) << "5 mm/s";
}

TEST(NominalLines, CountWhatTheMachineTakesForEvents) {
  MachineSettings machine = slow_along_y();
  machine.program.tool_change_s = 15.0;
  machine.program.spindle_start_s = 2.0;
  const auto lines = nominal_lines("G21 T1 M6\nS1000 M3\nM3\nG1 F600 X10\nM2\n", machine);
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[1].duration_s, 15.0);
  EXPECT_EQ(lines[2].duration_s, 2.0);
  EXPECT_EQ(lines[3].duration_s, 0.0) << "it turns";
}

TEST(NominalLines, HaveTheirPartsOfACurveThatStandsForMany) {
  std::string text = "G21 G90 G64 P0.01 Q0.01 F600\n";
  for (int i = 1; i <= 50; ++i) {
    text += "G1 X" + std::to_string(0.1 * i) + " Y" + std::to_string(0.002 * i * i) + "\n";
  }
  const auto lines = nominal_lines(text + "M2\n", default_machine());
  ASSERT_EQ(lines.size(), 52U);
  for (std::size_t i = 1; i <= 50; ++i) {
    // From i - 1 to i; Q lets it be elsewhere by 0.01 mm at both ends.
    const double length_mm = std::hypot(0.1, 0.002 * (2.0 * static_cast<double>(i) - 1.0));
    EXPECT_NEAR(lines[i + 1].duration_s, length_mm / 10.0, 0.02 / 10.0) << "line " << i + 1;
    EXPECT_GT(lines[i + 1].end_mm, lines[i].end_mm);
  }
}

TEST(NominalLines, OfOneAxisThatTurnsTakeItsFeedrate) {
  const auto machine = machine_of(
      "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 50000\n"
      "[axes.a]\nmax_velocity_deg_s = 90\nmax_acceleration_deg_s2 = 1000\nmax_jerk_deg_s3 = "
      "50000\n");
  const auto lines = nominal_lines("G21 G90 G61 G1 F1800 A60\nG0 A240\nM2\n", machine);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(lines[1].duration_s, 2.0, 1e-12) << "30 degrees a second";
  EXPECT_NEAR(lines[2].duration_s, 2.0, 1e-12) << "90 degrees a second";
  EXPECT_EQ(lines[2].end_mm, 0.0) << "X, Y and Z rest";
}

}  // namespace
}  // namespace kerf::program
