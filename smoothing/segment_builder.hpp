// Turns moves into path segments as they are programmed, exactly.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// Appends the segments of a move: normally one, of a NURBS with corners one for each smooth length,
// of an arc of very many turns several, of a dwell or an event none. Error: the curve is not valid;
// it names the line.
tl::expected<void, PathError> append_segments(const parser::Move& move,
                                              std::vector<PathSegment>& segments);

}  // namespace kerf::smoothing
