// The value of X in blocks that are read one after the other with the same variables.
#pragma once

#include <sstream>
#include <string>

#include "parser/block/block_grammar.hpp"
#include "parser/block/lexical_error.hpp"

namespace kerf::parser {

class Blocks {
 public:
  explicit Blocks(Dialect dialect = Dialect::rs274) : parameters(dialect) {}

  // "no X", or what is wrong as `column: message`.
  std::string x_of(const std::string& line) {
    if (!read_block(line, block, evaluator)) {
      const diagnostics::Fault fault = explain_stop(block);
      return std::to_string(fault.offset + 1) + ": " + fault.message;
    }
    if (!block.has('X')) {
      return "no X";
    }
    std::ostringstream out;
    out.precision(10);
    out << block.value('X');
    return out.str();
  }

  Parameters parameters;
  Evaluator evaluator{parameters};
  BlockWords block;
};

}  // namespace kerf::parser
