// G54 to G59.3, G52, G92 and G92.1 to G92.3; the tool length.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

void select_work_offset(const BlockCodes& codes, Coordinates& coordinates);
// G52 X5 puts the local origin to X5 of the work offset; G92 X5 names the tool's place X5.
Done set_local_offset(const RunningBlock& at, ModalState& state);
// G92.1 forgets the local offset, G92.2 lays it aside, G92.3 takes it up again.
void change_local_offset(const BlockCodes& codes, ModalState& state);

// tool_length.cpp: G43, G43.1, G43.2, G44 and G49.
Done set_length_offset(const RunningBlock& at, ModalState& state, const ToolTable& tools);

}  // namespace kerf::parser
