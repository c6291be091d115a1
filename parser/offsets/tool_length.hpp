// G43, G43.1, G43.2, G44 and G49.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

Done set_length_offset(const RunningBlock& at, ModalState& state, const ToolTable& tools);

}  // namespace kerf::parser
