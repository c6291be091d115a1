// The path mode and the dwell.
#pragma once

#include "parser/modal/machine_data.hpp"
#include "parser/modal/running_block.hpp"

namespace kerf::parser {

Done set_path_mode(const RunningBlock& at, ModalState& state, const MachineData& machine);
Done dwell(const RunningBlock& at, const ModalState& state);  // G4

}  // namespace kerf::parser
