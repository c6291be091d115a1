// Whether a given way to rest keeps the limits.
#pragma once

#include <span>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/way_ahead.hpp"

namespace kerf::lookahead {

// Looks at the laws, one after the other from the motion on, twice a tick. False: they exceed a
// limit, or leave what is known.
bool keeps_limits(std::span<const BrakingLaw> laws, const WayAhead& way, const PlanLimits& limits);

}  // namespace kerf::lookahead
