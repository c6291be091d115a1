// Calls in blocks: M97, M98, M99, G65, G66 and G67 as words.
#pragma once

#include <string>
#include <string_view>

#include "diagnostics/fault.hpp"
#include "parser/block/block.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/flow/call.hpp"

namespace kerf::parser {

// The first call code of a block; nullptr: it has none. One compare for each code.
inline const Word* find_program_code(const BlockWords& block, Dialect dialect) {
  const double first = rules_of(dialect).first_call_code;
  for (std::size_t i = 0; i < block.m_count; ++i) {
    if (block.m[i].value >= first && block.m[i].value <= 99.0) {
      return &block.m[i];
    }
  }
  return nullptr;
}
inline const Word* find_macro_code(const BlockWords& block) {
  for (std::size_t i = 0; i < block.g_count; ++i) {
    if (block.g[i].value >= 65.0 && block.g[i].value <= 67.0) {
      return &block.g[i];
    }
  }
  return nullptr;
}

// M98 or M97 (`code`), P and L. Fanuc writes the repeats before a program number of four digits
// too: P30100. `label` names the program; empty: P does.
diagnostics::Expected<Call> read_program_call(const BlockWords& block, const Word& code,
                                              Dialect dialect, std::string label);
// M99 and its P.
diagnostics::Expected<Return> read_m99(const BlockWords& block, const Word& code);
// Takes the code and its words out of the block, so that the rest can be run.
void remove_call(BlockWords& block, const Word& code);

// G65 and G66 with their arguments, read from the words' own text, since I, J and K may stand there
// several times: A B C D E F H I J K M Q R S T U V W X Y Z are #1 #2 #3 #7 #8 #9 #11 #4 #5 #6 #13
// #17 to #26; the n-th set of I J K is #3n+1 to #3n+3, n up to 10. The others are vacant.
diagnostics::Expected<Call> read_macro_call(std::string_view line, Evaluator& evaluator,
                                            std::string label);

}  // namespace kerf::parser
