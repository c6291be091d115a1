// What only the Fanuc dialect has: a group of their own for cycles, G4 with X and U, G30 P, G10 L10
// to L13 and L20, offsets and shapes of the program, numbers in least increments, ';' as the end of
// a block.
#pragma once

#include <string_view>

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
Expected<HomePosition> second_reference_point(const BlockWords& block, const MachineData& machine);
// G10 as the dialect has it, with the kinds that it shares.
Done set_fanuc_data(const RunningBlock& at, ModalState& state, ToolTable& tools);
// G06.2 P goes to 4 on the control; a program with more is for Kerf, or wrong.
void warn_of_order(const RunningBlock& at);

// shape.cpp: G54.1, and G50 and G51, G50.1 and G51.1, G68 and G69.
Done select_extended_offset(const RunningBlock& at, ModalState& state);
Done shape_program(const RunningBlock& at, ModalState& state);

// least_increment.cpp. Multiplies the block's coordinates and distances that have no decimal point
// by the control's least increment: with 0.001 mm X1000 is X1. In inches the increment is a tenth
// of that many inches, as on the control (IS-B: 0.001 mm, 0.0001 inch). Times and angles count in
// thousandths. Words of an expression, feeds, counts and numbers of things stay as they are.
void count_in_least_increments(const ModalState& state, double least_increment_mm,
                               BlockWords& block);

// end_of_block.cpp. Fanuc listings write the end of a block as ';', where other controls begin a
// comment. True: the text after a ';' is words, as in `G1 X5; G1 Y7;`, and no remark.
bool reads_as_block(std::string_view text);

}  // namespace kerf::parser
