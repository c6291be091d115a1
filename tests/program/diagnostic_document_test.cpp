#include "programs/kerf/report/diagnostic_document.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "diagnostics/errors/pages.hpp"

namespace kerf::program {
namespace {

using diagnostics::Diagnostic;
using nlohmann::json;

FileReport wrong_report() {
  FileReport report;
  report.file = "a part.ngc";
  report.status = ExitStatus::program_error;
  report.diagnostics = {Diagnostic({3, 11}, errors::kUnknownGCode, "G99 is not known"),
                        Diagnostic({7, 1}, errors::kToolChangeWithoutTool, "no tool")};
  report.diagnostics[0].block = diagnostics::excerpt_of("(\xC3\xA4\xC3\xB6) G1 G99", 10);
  return report;
}

TEST(JsonDiagnostics, HaveTheSchemaOfTheirDocument) {
  FileReport report = wrong_report();
  report.failures = {"the disk is full"};
  report.warnings = {"2 ticks late"};
  const json document = json::parse(json_diagnostics({report}));
  EXPECT_EQ(document["schema"], "kerf-diagnostics");
  EXPECT_EQ(document["schema_version"], 1);
  ASSERT_EQ(document["diagnostics"].size(), 2U);
  const json& first = document["diagnostics"][0];
  EXPECT_EQ(first["id"], "E0100");
  EXPECT_EQ(first["severity"], "error");
  EXPECT_EQ(first["file"], "a part.ngc");
  EXPECT_EQ(first["line"], 3);
  EXPECT_EQ(first["column"], 11);
  EXPECT_EQ(first["message"], "G99 is not known");
  EXPECT_EQ(first["block"], "(\xC3\xA4\xC3\xB6) G1 G99");
  EXPECT_EQ(first["caret"], 8);
  EXPECT_EQ(first["title"], errors::kUnknownGCode.title);
  EXPECT_EQ(first["remedy"], errors::kUnknownGCode.remedy);
  EXPECT_EQ(document["diagnostics"][1]["severity"], "warning");
  EXPECT_FALSE(document["diagnostics"][1].contains("block"));
  EXPECT_EQ(document["failures"][0]["message"], "the disk is full");
  EXPECT_EQ(document["warnings"][0]["file"], "a part.ngc");
}

TEST(JsonDiagnostics, NameTheSubprogramThatAnErrorIsIn) {
  FileReport report = wrong_report();
  report.diagnostics[0].file = "pocket.ngc";
  EXPECT_EQ(json::parse(json_diagnostics({report}))["diagnostics"][0]["file"], "pocket.ngc");
}

TEST(JsonDiagnostics, OfGoodProgramsAreEmptyLists) {
  const json document = json::parse(json_diagnostics({FileReport{}, FileReport{}}));
  EXPECT_TRUE(document["diagnostics"].is_array());
  EXPECT_TRUE(document["diagnostics"].empty());
  EXPECT_TRUE(document["failures"].empty());
}

TEST(SarifDiagnostics, HaveARuleForEachKindOfResult) {
  const json document = json::parse(sarif_diagnostics({wrong_report(), wrong_report()}));
  EXPECT_EQ(document["version"], "2.1.0");
  ASSERT_EQ(document["runs"].size(), 1U);
  const json& run = document["runs"][0];
  const json& rules = run["tool"]["driver"]["rules"];
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(run["tool"]["driver"]["name"], "kerf");
  ASSERT_EQ(run["results"].size(), 4U);
  for (const json& result : run["results"]) {
    const json& rule = rules[result["ruleIndex"].get<std::size_t>()];
    EXPECT_EQ(rule["id"], result["ruleId"]);
    EXPECT_EQ(rule["defaultConfiguration"]["level"], result["level"]);
    EXPECT_FALSE(rule["help"]["text"].get<std::string>().empty());
    EXPECT_FALSE(result["message"]["text"].get<std::string>().empty());
  }
}

TEST(SarifDiagnostics, GiveThePlaceInCharacters) {
  const json document = json::parse(sarif_diagnostics({wrong_report()}));
  const json& run = document["runs"][0];
  EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
  const json& place = run["results"][0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["region"]["startLine"], 3);
  EXPECT_EQ(place["region"]["startColumn"], 9) << "byte 11 after two characters of two bytes";
  const std::string uri = place["artifactLocation"]["uri"];
  EXPECT_EQ(uri, file_uri("a part.ngc"));
}

TEST(SarifDiagnostics, SayThatKerfCouldNotDoItsWork) {
  FileReport report;
  report.file = "<stdin>";
  report.status = ExitStatus::io_error;
  report.failures = {"cannot be read"};
  const json document = json::parse(sarif_diagnostics({report}));
  const json& invocation = document["runs"][0]["invocations"][0];
  EXPECT_EQ(invocation["executionSuccessful"], false);
  EXPECT_EQ(invocation["exitCode"], 5);
  const json& note = invocation["toolExecutionNotifications"][0];
  EXPECT_EQ(note["message"]["text"], "cannot be read");
  EXPECT_FALSE(note["locations"][0]["physicalLocation"]["artifactLocation"].contains("uri"));
  EXPECT_TRUE(document["runs"][0]["results"].empty());
}

TEST(SarifDiagnostics, CountAProgramWithErrorsAsWorkDone) {
  const json document = json::parse(sarif_diagnostics({wrong_report()}));
  EXPECT_EQ(document["runs"][0]["invocations"][0]["executionSuccessful"], true);
  EXPECT_EQ(document["runs"][0]["invocations"][0]["exitCode"], 1);
}

TEST(FileUri, IsAbsoluteAndPercentEncoded) {
  EXPECT_EQ(file_uri("/a b/\xC3\xA4%.ngc"), "file:///a%20b/%C3%A4%25.ngc");
  EXPECT_EQ(file_uri("/a/./b/../c.ngc"), "file:///a/c.ngc");
  EXPECT_EQ(file_uri("x.ngc"), file_uri((std::filesystem::current_path() / "x.ngc").string()));
}

}  // namespace
}  // namespace kerf::program
