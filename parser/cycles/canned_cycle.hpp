// G73, G74, G81 to G89: what the words of a block, with those of the blocks before, ask for.
#pragma once

#include <optional>
#include <vector>

#include "parser/cycles/drill_cycle.hpp"
#include "parser/modal/end_point.hpp"

namespace kerf::parser {

// Nothing: the block asks for no hole.
Expected<std::optional<DrillCycle>> read_cycle(const RunningBlock& at, ModalState& state,
                                               ContourPhase phase);

// The cycle's steps from where the tool is, in machine coordinates.
Done expand_on_machine(const RunningBlock& at, const ModalState& state, const DrillCycle& cycle,
                       std::vector<CycleStep>& steps);

}  // namespace kerf::parser
