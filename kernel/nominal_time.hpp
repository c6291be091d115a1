// What overrides make of a program's nominal time.
#pragma once

#include <kerf/kernel.hpp>

#include "parser/moves/move.hpp"

namespace kerf {

// Counts motion to the parts that follow the same overrides.
void add_motion(NominalTime& nominal, double duration_s, bool rapid,
                const parser::FollowedOverrides& follows);

// first + share * second, of all parts.
NominalTime sum_of(const NominalTime& first, const NominalTime& second, double share = 1.0);

// Of its motion, what a feed override of 0 holds.
double held_by_feed_s(const NominalTime& nominal);

// Of its motion. Precondition: no override is 0.
double motion_at_s(const NominalTime& nominal, const Overrides& overrides);

}  // namespace kerf
