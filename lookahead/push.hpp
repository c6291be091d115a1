// What is next of a program into the planner, its events as changes of the machine's outputs.
#pragma once

#include <vector>

#include "lookahead/path/block.hpp"
#include "lookahead/planner.hpp"
#include "parser/moves/move.hpp"

namespace kerf::lookahead {

// Both hand to the planner what is next of a program. Precondition: planner.wants_block().
// A dwell or an event: as a rest, or for the next motion.
void push_pause(const parser::Move& pause, Planner& planner);
// A block, with the changes that come with its first tick.
void push_block(Block block, const std::vector<parser::EventMove>& changes, Planner& planner);

}  // namespace kerf::lookahead
