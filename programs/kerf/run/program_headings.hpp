// The operations of a program file, as its comments name them.
#pragma once

#include <vector>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/report/time_parts.hpp"

namespace kerf::program {

// Of the rewound file, which stands at its end then; the first kMaxHeadings. One that cannot be
// read any more ends there: whoever runs it says so.
inline constexpr std::size_t kMaxHeadings = 10'000;
std::vector<Heading> headings_in(ProgramFile& file);

}  // namespace kerf::program
