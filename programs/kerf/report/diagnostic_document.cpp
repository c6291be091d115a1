#include "programs/kerf/report/diagnostic_document.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "diagnostics/diagnostic.hpp"

namespace kerf::program {

namespace {

using diagnostics::Diagnostic;
using diagnostics::ErrorPage;
using Json = nlohmann::ordered_json;

constexpr std::string_view kStandardInput = "<stdin>";

std::string written(const Json& json) {
  // ASCII alone, so that no control character of a name reaches a terminal. What is not UTF-8 in a
  // file name or a message becomes U+FFFD.
  return json.dump(2, ' ', true, Json::error_handler_t::replace) + "\n";
}

std::string_view level(diagnostics::Severity severity) {
  return severity == diagnostics::Severity::error ? "error" : "warning";
}

std::string file_of(const Diagnostic& diagnostic, const FileReport& report) {
  return diagnostic.file.empty() ? report.file : diagnostic.file;
}

Json json_of(const Diagnostic& diagnostic, const FileReport& report) {
  Json json{{"id", diagnostics::identifier(*diagnostic.page)},
            {"severity", level(diagnostic.severity)},
            {"file", file_of(diagnostic, report)},
            {"line", diagnostic.source.line},
            {"column", diagnostic.source.column},
            {"message", diagnostic.message}};
  if (!diagnostic.block.text.empty()) {
    json["block"] = diagnostic.block.text;
    json["caret"] = diagnostic.block.caret;
  }
  json["title"] = diagnostic.page->title;
  json["remedy"] = diagnostic.page->remedy;
  return json;
}

Json rule_of(const ErrorPage& page) {
  return {{"id", diagnostics::identifier(page)},
          {"shortDescription", {{"text", page.title}}},
          {"fullDescription", {{"text", page.meaning}}},
          {"help", {{"text", fmt::format("{} {}", page.meaning, page.remedy)}}},
          {"defaultConfiguration", {{"level", level(page.severity)}}}};
}

// The pages found, each once and in the order of their numbers.
class Rules {
 public:
  explicit Rules(const std::vector<FileReport>& reports) {
    for (const FileReport& report : reports) {
      for (const Diagnostic& diagnostic : report.diagnostics) {
        pages_.emplace(diagnostic.page->number, diagnostic.page);
      }
    }
  }

  // Counted from 0. Precondition: the page was found.
  [[nodiscard]] std::ptrdiff_t place_of(const ErrorPage& page) const {
    return std::distance(pages_.begin(), pages_.find(page.number));
  }
  [[nodiscard]] Json json() const {
    Json rules = Json::array();
    for (const auto& entry : pages_) {
      rules.push_back(rule_of(*entry.second));
    }
    return rules;
  }

 private:
  std::map<std::uint16_t, const ErrorPage*> pages_;
};

Json artifact(const std::string& file) {
  if (file == kStandardInput) {
    return {{"description", {{"text", "standard input"}}}};
  }
  return {{"uri", file_uri(file)}};
}

Json result_of(const Diagnostic& diagnostic, const FileReport& report, const Rules& rules) {
  const bool shown = !diagnostic.block.text.empty();
  const std::uint32_t column = shown ? diagnostic.block.characters + 1 : diagnostic.source.column;
  Json place{{"artifactLocation", artifact(file_of(diagnostic, report))}};
  if (diagnostic.source.line > 0) {
    place["region"] = {{"startLine", diagnostic.source.line}, {"startColumn", column}};
  }
  Json location{{"physicalLocation", place}};
  return {{"ruleId", diagnostics::identifier(*diagnostic.page)},
          {"ruleIndex", rules.place_of(*diagnostic.page)},
          {"level", level(diagnostic.severity)},
          {"message", {{"text", diagnostic.message}}},
          {"locations", Json::array({location})}};
}

Json notification(const FileReport& report, std::string_view grade, const std::string& message) {
  Json place{{"physicalLocation", {{"artifactLocation", artifact(report.file)}}}};
  return {{"level", grade}, {"message", {{"text", message}}}, {"locations", Json::array({place})}};
}

Json invocation_of(const std::vector<FileReport>& reports) {
  Json notes = Json::array();
  ExitStatus status = ExitStatus::done;
  for (const FileReport& report : reports) {
    status = status == ExitStatus::done ? report.status : status;
    for (const std::string& failure : report.failures) {
      notes.push_back(notification(report, "error", failure));
    }
    for (const std::string& warning : report.warnings) {
      notes.push_back(notification(report, "warning", warning));
    }
  }
  // Successful is a run of kerf that could look at the programs, whatever it found in them.
  const bool looked = status == ExitStatus::done || status == ExitStatus::program_error ||
                      status == ExitStatus::machine_fault;
  return {{"executionSuccessful", looked},
          {"exitCode", to_int(status)},
          {"toolExecutionNotifications", notes}};
}

}  // namespace

std::string json_diagnostics(const std::vector<FileReport>& reports) {
  Json json{{"schema", "kerf-diagnostics"}, {"schema_version", kDiagnosticsSchemaVersion}};
  json["diagnostics"] = Json::array();
  json["failures"] = Json::array();
  json["warnings"] = Json::array();
  for (const FileReport& report : reports) {
    for (const Diagnostic& diagnostic : report.diagnostics) {
      json["diagnostics"].push_back(json_of(diagnostic, report));
    }
    for (const std::string& failure : report.failures) {
      json["failures"].push_back({{"file", report.file}, {"message", failure}});
    }
    for (const std::string& warning : report.warnings) {
      json["warnings"].push_back({{"file", report.file}, {"message", warning}});
    }
  }
  return written(json);
}

std::string sarif_diagnostics(const std::vector<FileReport>& reports) {
  const Rules rules(reports);
  Json results = Json::array();
  for (const FileReport& report : reports) {
    for (const Diagnostic& diagnostic : report.diagnostics) {
      results.push_back(result_of(diagnostic, report, rules));
    }
  }
  Json driver{{"name", "kerf"}, {"version", KERF_VERSION}, {"rules", rules.json()}};
  Json run{{"tool", {{"driver", driver}}},
           {"invocations", Json::array({invocation_of(reports)})},
           {"columnKind", "unicodeCodePoints"},
           {"results", results}};
  return written({{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                  {"version", "2.1.0"},
                  {"runs", Json::array({run})}});
}

std::string file_uri(const std::string& path) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::error_code unknown_place;  // without a working directory the path stays as it is
  const std::filesystem::path full = std::filesystem::absolute(path, unknown_place);
  const std::string bytes = (unknown_place ? path : full.lexically_normal().string());
  std::string uri = "file://";
  for (const char c : bytes) {
    if (kPlain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
  }
  return uri;
}

}  // namespace kerf::program
