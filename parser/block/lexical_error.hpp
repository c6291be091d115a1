// What is wrong where the grammar stopped. Only called then, so it may take its time.
#pragma once

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"

namespace kerf::parser {

// Precondition: read_block returned false for this block.
diagnostics::Fault explain_stop(const BlockWords& block);

}  // namespace kerf::parser
