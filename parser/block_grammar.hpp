// The grammar of one line, behind a plain interface: Spirit stays in block_grammar.cpp.
#pragma once

#include <string_view>

#include "parser/block.hpp"

namespace kerf::parser {

// Reads a line without its line end into words. False: the grammar stopped at block.stopped_at
// (and block.stop may say why); the words before it are in the block.
bool read_block(std::string_view line, Block& block);

}  // namespace kerf::parser
