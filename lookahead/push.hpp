// Hands a program to the planner, its events as changes of the machine's outputs.
#pragma once

#include <vector>

#include "lookahead/path/block.hpp"
#include "lookahead/planner.hpp"
#include "parser/moves/move.hpp"

namespace kerf::lookahead {

// Precondition of both: planner.wants_block().
// A dwell or an event becomes a rest, or a change with the next motion.
void push_pause(const parser::Move& pause, Planner& planner);
// changes: those that take effect at the first tick on the block.
void push_block(Block block, const std::vector<parser::EventMove>& changes, Planner& planner);

}  // namespace kerf::lookahead
