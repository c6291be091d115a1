// What is wrong where the grammar stopped. Only called then, so it may take its time.
#pragma once

#include "parser/block.hpp"
#include "parser/fault.hpp"

namespace kerf::parser {

// Precondition: read_block returned false for this block.
Fault explain_stop(const Block& block);

// A file that is not a part program at all, told by its first line: UTF-16, binary data, another
// control's language. An empty message: nothing wrong.
Fault explain_first_line(std::string_view line);

}  // namespace kerf::parser
