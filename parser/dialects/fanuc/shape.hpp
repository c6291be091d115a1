// G54.1, G50 and G51, G50.1 and G51.1, G68 and G69.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

Done select_extended_offset(const RunningBlock& at, ModalState& state);  // G54.1
Done shape_program(const RunningBlock& at, ModalState& state);           // all the others

}  // namespace kerf::parser
