// Names and operators as they stand in an expression, and what to say where neither does.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "parser/expressions/expression_grammar.hpp"
#include "parser/expressions/functions.hpp"
#include "parser/expressions/operators.hpp"

namespace kerf::parser {

struct ScannedOperator {
  BinaryOperator op = BinaryOperator::none;
  const char* end = nullptr;
};
// The operator at `first`, blanks between its letters passed over.
ScannedOperator scan_operator(const char* first, const char* last);

// Letters, in capitals, without the blanks between them; the longest function has six.
struct ScannedName {
  std::array<char, 8> letters{};
  std::size_t size = 0;  // letters.size(): as long or longer
  const char* end = nullptr;

  [[nodiscard]] std::string_view text() const { return {letters.data(), size}; }
};
ScannedName scan_name(const char* first, const char* last);

const char* skip_blanks(const char* first, const char* last);

// Each keeps a fault about what stands at reading.at and returns false.
bool explain_no_value(const Reading& reading);
bool explain_not_closed(const Reading& reading);
bool explain_no_bracket(const Reading& reading);
bool explain_no_variable(const Reading& reading);
bool explain_bad_number(const Reading& reading);

}  // namespace kerf::parser
