#include "programs/kerf/run/last_words.hpp"

#include <utility>

#include "diagnostics/diagnostic.hpp"

namespace kerf::program {

namespace {

// The line of a subprogram's file is not one of the program.
std::string place_in_subprogram(const diagnostics::Diagnostic& of) {
  return of.file.empty() ? "" : of.file + ":" + std::to_string(of.source.line) + ": ";
}

}  // namespace

std::vector<ProgramMessage> last_words(const FileReport& report, const std::string& said) {
  std::vector<ProgramMessage> words;
  for (const auto& found : report.diagnostics) {
    if (found.severity == Severity::error) {
      words.push_back({.line = found.source.program_line(),
                       .text = place_in_subprogram(found) + found.message + " [" +
                               diagnostics::identifier(*found.page) + "]"});
    }
  }
  // That of the machine is the first failure; others are of files.
  std::uint32_t line = report.machine_fault ? report.machine_fault->line : 0;
  for (const std::string& failure : report.failures) {
    if (failure != said) {
      words.push_back({.line = std::exchange(line, 0), .text = failure});
    }
  }
  return words;
}

}  // namespace kerf::program
