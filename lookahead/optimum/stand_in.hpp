// The classical plan over blocks on which the time optimum is not found.
#pragma once

#include <cstddef>

#include "lookahead/span_schedule.hpp"

namespace kerf::lookahead {

// How long the classical schedule takes from rest over the first blocks of the window to rest at
// the end of the last of them. Precondition: 0 < count <= blocks.size().
double classical_s(const Window<Block>& blocks, std::size_t count,
                   const SpanSchedule::Settings& settings);

}  // namespace kerf::lookahead
