// Whether a given way to rest keeps the limits.
#pragma once

#include <span>

#include "lookahead/optimum/way_ahead.hpp"
#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

// Looks at the laws, one after the other from the motion on, twice a tick. False: they exceed a
// limit, or leave the block.
bool keeps_limits(std::span<const profiles::CellLaw> laws, const WayAhead& way,
                  const PlanLimits& limits);

}  // namespace kerf::lookahead
