// M62 to M68: digital and analog outputs, waiting for an input.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

Done switch_in_out(const RunningBlock& at, ModalState& state);

}  // namespace kerf::parser
