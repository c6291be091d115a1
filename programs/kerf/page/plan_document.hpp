// A program and its run as the page reads them: docs/page-data.md.
#pragma once

#include <string>

#include <kerf/machine.hpp>

#include "programs/kerf/page/plan_gatherer.hpp"
#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// Raised when a page of before could not read the data any more. The page names its own.
inline constexpr int kPlanVersion = 2;

// Bytes, not packed: text that is base64 of them, packed with zlib, goes into the page.
[[nodiscard]] std::string plan_document(const FileReport& report, const MachineSettings& settings,
                                        const PageRecord& record);

}  // namespace kerf::program
