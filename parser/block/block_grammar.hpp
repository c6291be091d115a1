// The grammar of one line, behind a plain interface: Spirit stays in block_grammar.cpp.
#pragma once

#include <string_view>

#include "parser/block/block.hpp"
#include "parser/expressions/evaluator.hpp"

namespace kerf::parser {

// Reads a line without its line end into words, and does its assignments. False: the grammar
// stopped at block.stopped_at (and block.stop may say why); the words before it are in the block.
// The block's fault is the evaluator's and good until the next call.
bool read_block(std::string_view text, BlockWords& block, Evaluator& evaluator);

}  // namespace kerf::parser
