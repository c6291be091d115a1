// A comparison for a machinist, and as JSON for other programs (docs/json.md).
#pragma once

#include <string>

#include "programs/kerf/compare/comparison.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// The programs as they ran; comparison is null where one of them did not.
struct ComparedReports {
  const FileReport& first;
  const FileReport& second;
  const Comparison* comparison = nullptr;
};

// Some lines of text, each with its newline. Without a comparison, how those that do not fit would.
[[nodiscard]] std::string comparison_text(const ComparedReports& compared);

// One object on one line, with its end.
[[nodiscard]] std::string comparison_json(const ComparedReports& compared, ExitStatus status);

}  // namespace kerf::program
