// Moves to path parts as they are programmed: every curve exact and valid.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "parser/moves/move.hpp"
#include "smoothing/path_error.hpp"
#include "smoothing/path_part.hpp"

namespace kerf::smoothing {

// Appends the parts of a move, normally one: a NURBS with corners gives one for each smooth part.
// A dwell or an event gives none. Error: the curve is not valid, with the line to blame.
tl::expected<void, PathError> append_parts(const parser::Move& move, std::vector<PathPart>& parts);

}  // namespace kerf::smoothing
