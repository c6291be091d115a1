// Moves to path segments as they are programmed: every curve exact and valid.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// Appends the segments of a move, normally one: a NURBS with corners gives one for each smooth
// segment. A dwell or an event gives none. Error: the curve is not valid, with the line to blame.
tl::expected<void, PathError> append_segments(const parser::Move& move,
                                              std::vector<PathSegment>& segments);

}  // namespace kerf::smoothing
