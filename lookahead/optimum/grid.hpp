// Where the cells of the time optimum end.
#pragma once

#include <vector>

#include "lookahead/optimum/block_path.hpp"
#include "lookahead/optimum/speed_estimate.hpp"

namespace kerf::lookahead {

// The cells of a block: about a tick long where the estimated feedrate changes or turning takes its
// part of the axes' limits, growing with the distance from such places where nothing happens. They
// end where derivatives jump. ends: the feedrates of the joints; rests are to be given as infinite
// and refined afterwards.
std::vector<Cell> grid_of(const BlockPath& path, const EndFeeds& ends, const PlanLimits& limits);

}  // namespace kerf::lookahead
