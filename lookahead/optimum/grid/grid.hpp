// Where the cells of the time optimum end.
#pragma once

#include <vector>

#include "lookahead/optimum/grid/cell_stops.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

// The cells of a block: about a tick long where the estimated feedrate changes or curvature takes
// its part of the axes' limits, growing with the distance from such places where nothing happens.
// They end where derivatives jump. Around jumps the cells have their share of the limits. Rests are
// to be refined afterwards.
std::vector<Cell> grid_of(const BlockPath& path, const EndJunctions& ends,
                          const PlanLimits& limits);

// How fast the ends of a block can be passed for what is on it, were there nothing beyond.
EndFeeds end_feeds_of(const BlockPath& path, const PlanLimits& limits);

enum class RestAt { begin, end };

// Divides the cells towards a rest at their beginning or end so that a launch or landing and the
// ramp after it find room; the outermost cell is then that launch or landing.
void refine_to_rest(std::vector<Cell>& cells, RestAt where, const PathAt& path,
                    const PlanLimits& limits);

}  // namespace kerf::lookahead
