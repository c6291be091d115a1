// The feedrate that both the chord error and the axes allow.
#pragma once

#include "lookahead/classical/turn_scan.hpp"
#include "lookahead/path/ceiling.hpp"

namespace kerf::lookahead {

// The lower one of a ceiling and what turning allows.
Ceiling lower_ceiling(const Ceiling& ceiling, const Turning& turning);

}  // namespace kerf::lookahead
