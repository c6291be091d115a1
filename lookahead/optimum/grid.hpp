// Where the cells of the time optimum end.
#pragma once

#include <vector>

#include "lookahead/optimum/block_path.hpp"
#include "lookahead/optimum/limit_check.hpp"
#include "lookahead/optimum/speed_estimate.hpp"

namespace kerf::lookahead {

// The cells of a block: about a tick long where the estimated feedrate changes or turning takes its
// part of the axes' limits, growing with the distance from such places where nothing happens. They
// end where derivatives jump. ends: the feedrates of the joints; rests are to be given as infinite
// and refined afterwards.
std::vector<Cell> grid_of(const BlockPath& path, const EndFeeds& ends, const PlanLimits& limits);

// Divides the cells towards a rest at their beginning or end so that a launch or landing and the
// ramp after it find room; the outermost cell is then that launch or landing.
enum class RestAt { begin, end };
void refine_to_rest(std::vector<Cell>& cells, RestAt where, const PathAt& path,
                    const PlanLimits& limits);

}  // namespace kerf::lookahead
