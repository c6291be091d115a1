// What the clients of a run hear before its end, where it ends with a fault or an error.
#pragma once

#include <string>
#include <vector>

#include <kerf/program_data.hpp>

#include "programs/kerf/report/report.hpp"

namespace kerf::program {

// The errors of the report, each with the line of the program that it belongs to; but the one that
// the controller has said by itself.
[[nodiscard]] std::vector<ProgramMessage> last_words(const FileReport& report,
                                                     const std::string& said);

}  // namespace kerf::program
