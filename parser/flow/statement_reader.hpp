// Recognises the lines that say which line is next.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "diagnostics/fault.hpp"
#include "parser/dialects/dialect.hpp"
#include "parser/flow/statement.hpp"
#include "parser/flow/statement_text.hpp"

namespace kerf::parser {

// One look at the byte where the words begin. False: the line is no statement for sure.
inline bool may_be_statement(std::string_view line, std::size_t at, const DialectRules& rules) {
  const auto first = static_cast<char>(at < line.size() ? line[at] | 0x20 : ' ');
  return first == 'o' || (first == ':' && rules.numbered_programs) ||
         (rules.macro_statements &&
          (first == 'i' || first == 'w' || first == 'g' || first == 'e' || first == 'd'));
}

// Reads the statement whose words begin at `at`: the label and the keyword, not what follows them.
// A plain block has Keyword::none.
diagnostics::Expected<Statement> read_statement(std::string_view line, std::size_t at,
                                                Dialect dialect);

// An o-word as it is written, for messages.
std::string_view name_of(Keyword keyword);

}  // namespace kerf::parser
