// G41, G42, G41.1, G42.1, and what may not stand between them and G40.
#pragma once

#include "parser/compensation/cutter_compensation.hpp"
#include "parser/modal/running_block.hpp"

namespace kerf::parser {

inline constexpr Tenths kG40 = 400;

// What moves the coordinates, takes another tool or goes elsewhere must wait for G40, as with
// LinuxCNC. A G40 in the same block comes after the plane and M6 and before the rest.
Done allowed_while_compensating(const RunningBlock& at, const ModalState& state);

// How compensation begins. `on`: it is on already, which is a fault.
Expected<CompensationStart> read_compensation(const RunningBlock& at, ModalState& state,
                                              const ToolTable& tools, bool on);

}  // namespace kerf::parser
