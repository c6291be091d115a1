// What only the Fanuc dialect has: a group of their own for cycles, G4 with X and U, G30 P, G10 L10
// to L13 and L20.
#pragma once

#include "parser/modal/machine_data.hpp"
#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// Letters that codes take here and not in RS274.
Letters letters_of_fanuc(const RunningBlock& at);
// Cycles do not end the motion of group 01, they lie over it: G80 alone comes back to it, and its
// axis words are that motion's.
void settle_cycle_group(const RunningBlock& at, BlockCodes& codes, ModalState& state);
// G4: P in milliseconds, X and U in seconds.
Done fanuc_dwell(const RunningBlock& at, const ModalState& state);
// G30 P2 to P4: the second to the fourth reference point; without P the second.
Expected<HomePosition> second_reference_point(const Block& block, const MachineData& machine);
// G10 as the dialect has it, with the kinds that it shares.
Done set_fanuc_data(const RunningBlock& at, ModalState& state, ToolTable& tools);
// G06.2 P goes to 4 on the control; a program with more is for Kerf, or wrong.
void warn_of_order(const RunningBlock& at);

}  // namespace kerf::parser
