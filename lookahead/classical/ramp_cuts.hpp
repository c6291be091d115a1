// Where a ramp below a limit curve is better run as several.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/classical/slope.hpp"

namespace kerf::lookahead {

// The samples at which the ramp from the foot is to be cut, ascending; none where one ramp of one
// acceleration takes no more than twice the time of the fastest ramp.
//
//      v^2            . top         A ramp of one acceleration is a straight line over s in v^2.
//       |         _.-'              No motion is faster than the lower convex hull of the limit
//       |      .-'    /             curve; each side of it has an acceleration of its own. Where
//       |   .-'     /               the foot stands in a feature of some nanometres, the first
//       |.-'      / one ramp        side is so flat that a ramp that goes on with it would crawl
//       |       /                   for the whole length of the segment; a cut after it costs one
//       |  |_./                     instant without acceleration.
//       +---------------- s
//
// The hull is thinned where its sides differ little; of its corners the one that leaves the least
// time in both parts is cut at, then each part again. Of the jerk only this is taken into account:
// a place of the limit curve that it keeps out of reach from the foot does not count. Samples:
// distance from 0, ascending, their feedrate not below 0; the ramp begins with that of the first.
// The jerk may be infinite.
std::vector<std::size_t> ramp_cuts(const std::vector<Slope::Sample>& samples,
                                   const profiles::RampLimits& limits);

}  // namespace kerf::lookahead
