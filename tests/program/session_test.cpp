#include "programs/kerf/run/session.hpp"

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

// What a page is shown of a program before it is planned, and what becomes of the program.
struct ShownFirst {
  int times = 0;
  std::optional<double> way_mm;  // of the path that is shown
  ExitStatus end = ExitStatus::done;
  bool has_moved = false;
};

ShownFirst shown_first(const std::string& text) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "program.ngc";
  std::ofstream(file) << text;
  PageRecord page;
  ShownFirst shown;
  page.show_path = [&](const FileReport& report) {
    EXPECT_EQ(report.status, ExitStatus::done);
    EXPECT_FALSE(page.motion);
    ++shown.times;
    shown.way_mm = static_cast<double>(page.planned.value().outline().points().back().tick) * 1e-6;
  };
  Options options;
  options.command = Subcommand::report;
  options.quiet = true;
  shown.end = process_file(file, options, default_machine(), &page).status;
  shown.has_moved = page.motion.has_value();
  return shown;
}

TEST(PathBeforeTimes, IsShownOnceAndThePlanFollows) {
  const ShownFirst shown = shown_first("G21 G90 G61 G1 F600 X3\nY4\nM2\n");
  EXPECT_EQ(shown.times, 1);
  EXPECT_EQ(shown.way_mm, 7.0);
  EXPECT_EQ(shown.end, ExitStatus::done);
  EXPECT_TRUE(shown.has_moved);
}

TEST(PathBeforeTimes, IsNotShownOfAProgramThatDoesNotRun) {
  const ShownFirst wrong = shown_first("G21 G90 G1 F600 X3\nG1 G2 X4\nM2\n");
  EXPECT_EQ(wrong.times, 0);
  EXPECT_EQ(wrong.end, ExitStatus::program_error);
  const ShownFirst far = shown_first("G21 G90 G1 F600 X5000\nM2\n");
  EXPECT_EQ(far.times, 0);
  EXPECT_EQ(far.end, ExitStatus::machine_fault);
}

}  // namespace
}  // namespace kerf::program
