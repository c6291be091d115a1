// Moves to blocks: a valid curve with its limits and the feedrate it allows at each point.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "lookahead/block.hpp"
#include "lookahead/limits.hpp"
#include "lookahead/plan_error.hpp"
#include "parser/move.hpp"

namespace kerf::lookahead {

// Appends the blocks of a move, normally one: a NURBS with corners gives one for each smooth part.
// A dwell or an event gives none. Error: the curve is not valid, with the line to blame.
tl::expected<void, PlanError> append_blocks(const parser::Move& move, const PlanLimits& limits,
                                            std::vector<Block>& blocks);

// The same without ceilings, for a look at the geometry alone.
tl::expected<void, PlanError> append_curves(const parser::Move& move,
                                            std::vector<curves::Curve>& curves);

}  // namespace kerf::lookahead
