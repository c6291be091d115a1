#include "programs/kerf/run/session.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

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

PlanGatherer planned(const std::filesystem::path& file, const TickWindow& window) {
  PageRecord page;
  page.window = window;
  Options options;
  options.command = Subcommand::report;
  options.quiet = true;
  EXPECT_EQ(process_file(file, options, default_machine(), &page).status, ExitStatus::done);
  return page.motion.value();
}

TEST(PartOfARun, HasItsTicksAloneAndEndsAfterThem) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder / "program.ngc";
  std::ofstream(file) << "G21 G90 G61 G1 F600 X10\nG2 X20 I5\nM2\n";
  const PlanGatherer whole = planned(file, {});
  const PlanGatherer part = planned(file, {.first = 900, .last = 1099});
  ASSERT_GT(whole.last_tick(), 2000) << "25.7 mm at 10 mm/s";
  EXPECT_EQ(part.last_tick(), 1099);
  ASSERT_EQ(part.columns().columns(), 200U);
  ASSERT_EQ(part.columns().series().size(), whole.columns().series().size());
  for (std::size_t i = 0; i < part.columns().series().size(); ++i) {
    const auto& all = whole.columns().series()[i].min;
    EXPECT_EQ(part.columns().series()[i].min, std::vector(all.begin() + 900, all.begin() + 1100));
  }
}

}  // namespace
}  // namespace kerf::program
