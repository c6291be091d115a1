// Events of a program as changes of the machine's outputs.
#pragma once

#include <cstdint>
#include <optional>

#include "interp/outputs.hpp"
#include "lookahead/planner.hpp"
#include "parser/move.hpp"

namespace kerf::lookahead {

// Nothing: the event changes no output (a stop).
std::optional<interp::Switch> switch_of(const parser::EventMove& event);

// Hands the event to the planner: as a rest, or for the next motion. Precondition:
// planner.wants_block().
void push_event(const parser::EventMove& event, std::uint32_t line, Planner& planner);

// M62, M63 and M67: the change comes with the next motion, and the tool does not rest for it.
bool is_at_motion(parser::EventKind kind);

}  // namespace kerf::lookahead
