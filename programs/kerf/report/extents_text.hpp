// Where a program's path lies, in words.
#pragma once

#include <string>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// "x 0.000 to 20.000, y ..., z ... mm": of the plan, with the machine's other axes.
[[nodiscard]] std::string extents_text(const FileReport& report);

// The rows of the summary: all motion and cutting, on the machine and in the program's coordinates.
// Of a program of which that is not known, that was stopped or that started at a line: what ran.
[[nodiscard]] std::string extents_rows(const FileReport& report);

// Of a program that does not fit: by how much, and with which work offsets it would. Else empty.
[[nodiscard]] std::string misfit_text(const FileReport& report);

}  // namespace kerf::program
