// Errors and warnings of programs as one document for other programs.
#pragma once

#include <string>
#include <vector>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

inline constexpr int kDiagnosticsSchemaVersion = 1;

// The schema is in docs/diagnostics.md.
std::string json_diagnostics(const std::vector<FileReport>& reports);

// SARIF 2.1.0 (OASIS): one run; the pages of what was found are its rules.
std::string sarif_diagnostics(const std::vector<FileReport>& reports);

// "file:///..." of a path as the command line has it, percent-encoded (RFC 8089).
std::string file_uri(const std::string& path);

}  // namespace kerf::program
