// The feedrate that both the chord error and the axes allow.
#pragma once

#include "lookahead/ceiling.hpp"
#include "lookahead/turn_scan.hpp"

namespace kerf::lookahead {

// The lower one of a ceiling and what turning allows.
Ceiling lower_ceiling(const Ceiling& ceiling, const Turning& turning);

}  // namespace kerf::lookahead
