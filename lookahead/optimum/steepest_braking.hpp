// A way to rest step by step, of what the limits leave at each.
#pragma once

#include <vector>

#include "lookahead/optimum/way_ahead.hpp"
#include "profiles/cell_law.hpp"

namespace kerf::lookahead {

// Steps of constant jerk of about a tick, and a landing of constant jerk. Each step takes the
// lowest jerk that the path and every axis leave at both of its ends; where the jerk that leads
// from here to rest in one go is as high as a share of the limit, the landing begins. No step looks
// farther ahead than its own end, which is enough where the limits open as the feedrate falls, as
// they do on most of a smooth curve.
//
// It has a way where the search has none: the motion may be at a limit already.
//
// Some ways, the one that lands last first; whether the limits hold between the ends of steps and
// while it lands, the caller looks at. None: the way leaves what is known, or comes to a place that
// leaves no jerk.
//
// Weakness: that may be where limits close in faster than a step sees, as where an axis turns that
// had to be entered slower or with less braking.
std::vector<std::vector<profiles::CellLaw>> steepest_braking(const StartState& begin,
                                                             const WayAhead& way,
                                                             const PlanLimits& limits);

}  // namespace kerf::lookahead
