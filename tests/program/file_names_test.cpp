#include "programs/kerf/page/file_names.hpp"

#include <gtest/gtest.h>

#include "diagnostics/errors/pages.hpp"

namespace kerf::program {
namespace {

FileReport report_with_folders() {
  FileReport report;
  report.file = "/srv/jobs/part.ngc";
  report.machine = "../machines/mill.toml";
  const auto add = [&report](const std::string& message, const std::string& file) {
    report.diagnostics.emplace_back(diagnostics::SourcePosition{}, errors::kUnknownGCode, message);
    report.diagnostics.back().file = file;
  };
  add("in /srv/jobs/part.ngc and lib/drill.ngc", "");
  add("F", "lib/drill.ngc");
  report.failures = {"/srv/jobs/part.ngc: /srv/jobs/part.ngc has a fault"};
  report.warnings = {"../machines/mill.toml: 3 / 4"};
  return report;
}

TEST(FileNames, AreAllThatAPageSaysOfWhereFilesLie) {
  const FileReport named = with_file_names(report_with_folders());
  EXPECT_EQ(named.file, "part.ngc");
  EXPECT_EQ(named.machine, "mill.toml");
  EXPECT_EQ(named.diagnostics[0].file, "") << "of the program itself";
  EXPECT_EQ(named.diagnostics[0].message, "in part.ngc and drill.ngc");
  EXPECT_EQ(named.diagnostics[1].file, "drill.ngc");
  EXPECT_EQ(named.failures[0], "part.ngc: part.ngc has a fault");
  EXPECT_EQ(named.warnings[0], "mill.toml: 3 / 4");
}

TEST(FileNames, AreNoUnitsThatEndLikeAFolder) {
  FileReport report;
  report.file = "mm/part.ngc";
  report.diagnostics.emplace_back(diagnostics::SourcePosition{}, errors::kUnknownGCode,
                                  "a feed of 20000 mm/min, by 'mm/drill.ngc' and mm/slot");
  const FileReport named = with_file_names(report);
  EXPECT_EQ(named.diagnostics[0].message, "a feed of 20000 mm/min, by 'drill.ngc' and slot");
}

TEST(FileNames, StayWhatTheyAreWithoutFolders) {
  FileReport report;
  report.file = "part.ngc";
  report.machine = "default";
  report.failures = {"1 / 2"};
  const FileReport named = with_file_names(report);
  EXPECT_EQ(named.file, "part.ngc");
  EXPECT_EQ(named.machine, "default");
  EXPECT_EQ(named.failures, report.failures);
}

}  // namespace
}  // namespace kerf::program
