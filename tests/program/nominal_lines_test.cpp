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
std::vector<double> nominal_lines(const std::string& text, const MachineSettings& machine) {
  const TemporaryFolder folder;
  const auto file = folder / "program.ngc";
  std::ofstream(file) << text;
  PageRecord page;
  std::vector<double> seconds;
  page.show_path = [&](const FileReport& /*report*/) { seconds = page.nominal.value().seconds(); };
  Options options;
  options.command = Subcommand::report;
  options.quiet = true;
  process_file(file, options, machine, &page);
  return seconds;
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
  const auto seconds =
      nominal_lines("G21 G90 G61\nG1 F600 X30\n\nG2 X50 I10\nM2\n", slow_along_y());
  ASSERT_EQ(seconds.size(), 5U);
  EXPECT_NEAR(seconds[2], 3.0, 1e-12);
  EXPECT_EQ(seconds[3], 0.0);
  EXPECT_NEAR(seconds[4], std::numbers::pi, 1e-9);
}

TEST(NominalLines, AreBoundByPathAndAxes) {
  const auto seconds =
      nominal_lines("G21 G90 G61 G0 X50\nG1 F6000 Y30\nF60000 X0\nM2\n", slow_along_y());
  ASSERT_EQ(seconds.size(), 4U);
  EXPECT_NEAR(seconds[1], 0.5, 1e-12) << "a rapid";
  EXPECT_NEAR(seconds[2], 6.0, 1e-12) << "5 mm/s of Y";
  EXPECT_NEAR(seconds[3], 0.5, 1e-12) << "100 mm/s of the path";
}

TEST(NominalLines, CountADwellAndEachRoundOfALoop) {
  const auto seconds = nominal_lines(
      "G21 G61 G1 F600\nG4 P1.5\no1 repeat [4]\nG91 X5\no1 endrepeat\nM2\n", slow_along_y());
  ASSERT_EQ(seconds.size(), 5U);
  EXPECT_EQ(seconds[2], 1.5);
  EXPECT_NEAR(seconds[4], 2.0, 1e-12);
}

TEST(NominalLines, HaveTheirPartsOfACurveThatStandsForMany) {
  std::string text = "G21 G90 G64 P0.01 Q0.01 F600\n";
  for (int i = 1; i <= 50; ++i) {
    text += "G1 X" + std::to_string(0.1 * i) + " Y" + std::to_string(0.002 * i * i) + "\n";
  }
  const auto seconds = nominal_lines(text + "M2\n", default_machine());
  ASSERT_EQ(seconds.size(), 52U);
  for (std::size_t i = 1; i <= 50; ++i) {
    // From i - 1 to i; Q lets it be elsewhere by 0.01 mm at both ends.
    const double length_mm = std::hypot(0.1, 0.002 * (2.0 * static_cast<double>(i) - 1.0));
    EXPECT_NEAR(seconds[i + 1], length_mm / 10.0, 0.02 / 10.0) << "line " << i + 1;
  }
}

TEST(NominalLines, OfOneAxisThatTurnsTakeItsFeedrate) {
  const auto machine = machine_of(
      "[path]\nmax_velocity_mm_s = 100\nmax_acceleration_mm_s2 = 2000\nmax_jerk_mm_s3 = 50000\n"
      "[axes.a]\nmax_velocity_deg_s = 90\nmax_acceleration_deg_s2 = 1000\nmax_jerk_deg_s3 = "
      "50000\n");
  const auto seconds = nominal_lines("G21 G90 G61 G1 F1800 A60\nG0 A240\nM2\n", machine);
  ASSERT_EQ(seconds.size(), 3U);
  EXPECT_NEAR(seconds[1], 2.0, 1e-12) << "30 degrees a second";
  EXPECT_NEAR(seconds[2], 2.0, 1e-12) << "90 degrees a second";
}

}  // namespace
}  // namespace kerf::program
