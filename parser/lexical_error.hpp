// What is wrong where the grammar stopped. Only called then, so it may take its time.
#pragma once

#include "parser/block.hpp"
#include "parser/fault.hpp"

namespace kerf::parser {

// Precondition: read_block returned false for this block.
Fault explain_stop(const Block& block);

}  // namespace kerf::parser
