// The grid of the time optimum: where its cells end.
#pragma once

#include <vector>

#include "lookahead/optimum/grid/cell_stops.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

// The cells of a block: about a tick long where the estimated feedrate changes or curvature takes
// its part of the axes' limits, and longer with the distance from such places. They end where
// derivatives jump. Around jumps the cells have their share of the limits. Call refine_to_rest()
// afterwards for rests.
std::vector<Cell> grid_of(const BlockPath& path, const EndJunctions& ends,
                          const PlanLimits& limits);

// The highest feedrates at the ends of a block by its own path alone, without its neighbours.
EndFeeds end_feeds_of(const BlockPath& path, const PlanLimits& limits);

// The cell in parts of these lengths, of which the last ends where the cell ends.
std::vector<Cell> parts_of(const Cell& cell, const std::vector<double>& lengths_mm,
                           const PathAt& path);

enum class RestAt { begin, end };

// Divides the cells towards a rest at their beginning or end so that a launch or landing and the
// ramp after it find room; the outermost cell is then that launch or landing.
void refine_to_rest(std::vector<Cell>& cells, RestAt where, const PathAt& path,
                    const PlanLimits& limits);

}  // namespace kerf::lookahead
