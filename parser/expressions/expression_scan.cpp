#include "parser/expressions/expression_scan.hpp"

#include <algorithm>
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "parser/expressions/evaluator.hpp"
#include "parser/text/character_error.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

// After `rest` at `first`; nullptr where something else stands there.
const char* behind(const char* first, const char* last, std::string_view rest) {
  for (const char wanted : rest) {
    first = skip_blanks(first, last);
    if (first == last || detail::to_upper(*first) != wanted) {
      return nullptr;
    }
    ++first;
  }
  return first;
}

struct Spelling {
  std::string_view text;
  BinaryOperator op;
};
constexpr std::array kSpellings = {
    Spelling{"EQ", BinaryOperator::equal},       Spelling{"NE", BinaryOperator::not_equal},
    Spelling{"GT", BinaryOperator::greater},     Spelling{"GE", BinaryOperator::greater_equal},
    Spelling{"LT", BinaryOperator::less},        Spelling{"LE", BinaryOperator::less_equal},
    Spelling{"MOD", BinaryOperator::modulo},     Spelling{"AND", BinaryOperator::conjunction},
    Spelling{"OR", BinaryOperator::disjunction}, Spelling{"XOR", BinaryOperator::exclusive_or},
};

std::size_t letters_in(std::string_view rest) {
  return static_cast<std::size_t>(std::find_if_not(rest.begin(), rest.end(), detail::is_letter) -
                                  rest.begin());
}

// What stands at reading.at, as a message shows it.
std::string found(const Reading& reading) {
  const std::string_view rest(reading.at, static_cast<std::size_t>(reading.end - reading.at));
  if (rest.empty()) {
    return "the end of the line";
  }
  if (rest[0] == '(' || rest[0] == ';') {
    return "a comment";
  }
  if (detail::is_letter(rest[0])) {
    return quoted(rest.substr(0, letters_in(rest)));
  }
  if (is_digit(rest[0])) {
    const std::size_t length = rest.find_first_not_of("0123456789.");
    return quoted(rest.substr(0, length));
  }
  return quoted(rest.substr(0, 1));
}

bool is_foreign_byte(const Reading& reading) {
  if (reading.at == reading.end) {
    return false;
  }
  const auto byte = static_cast<unsigned char>(*reading.at);
  return byte < 0x20 || byte >= 0x7F;
}

bool explain_foreign_byte(const Reading& reading) {
  const std::string_view rest(reading.at, static_cast<std::size_t>(reading.end - reading.at));
  const diagnostics::Fault fault = explain_character(rest, 0);
  return reading.evaluator.fail(reading.at, *fault.page, fault.message);
}

// The operator or function that stands before reading.at, blanks between them passed over.
std::string_view before(const Reading& reading) {
  const char* last = reading.at;
  while (last != reading.begin && is_blank(last[-1])) {
    --last;
  }
  const char* first = last;
  while (first != reading.begin && detail::is_letter(first[-1])) {
    --first;
  }
  if (first == last && first != reading.begin) {
    --first;
    first -= *first == '*' && first != reading.begin && first[-1] == '*' ? 1 : 0;
  }
  return {first, static_cast<std::size_t>(last - first)};
}

}  // namespace

const char* skip_blanks(const char* first, const char* last) {
  while (first != last && is_blank(*first)) {
    ++first;
  }
  return first;
}

ScannedOperator scan_operator(const char* first, const char* last) {
  if (first == last) {
    return {};
  }
  switch (*first) {
    case '+':
      return {BinaryOperator::add, first + 1};
    case '-':
      return {BinaryOperator::subtract, first + 1};
    case '/':
      return {BinaryOperator::divide, first + 1};
    case '*':
      if (last - first > 1 && first[1] == '*') {
        return {BinaryOperator::power, first + 2};
      }
      return {BinaryOperator::multiply, first + 1};
    default:
      break;
  }
  if (!detail::is_letter(*first)) {
    return {};
  }
  for (const Spelling& spelling : kSpellings) {
    if (detail::to_upper(*first) == spelling.text[0]) {
      if (const char* const end = behind(first + 1, last, spelling.text.substr(1))) {
        return {spelling.op, end};
      }
    }
  }
  return {};
}

ScannedName scan_name(const char* first, const char* last) {
  ScannedName name;
  name.end = first;
  for (const char* at = first; at != last && name.size < name.letters.size(); ++at) {
    if (detail::is_letter(*at)) {
      name.letters[name.size++] = detail::to_upper(*at);
      name.end = at + 1;
    } else if (!is_blank(*at)) {
      break;
    }
  }
  return name;
}

bool explain_no_value(const Reading& reading) {
  Evaluator& evaluator = reading.evaluator;
  if (is_foreign_byte(reading)) {
    return explain_foreign_byte(reading);
  }
  const std::string_view last = before(reading);
  if (reading.at != reading.end && (*reading.at == '-' || *reading.at == '+') &&
      (last == "-" || last == "+")) {
    return evaluator.fail(reading.at, errors::kMalformedNumber,
                          joined({"malformed number ", quoted(std::string(last) + *reading.at),
                                  ": more than one sign"}));
  }
  if (reading.at != reading.end && detail::is_letter(*reading.at)) {
    const std::string_view rest(reading.at, static_cast<std::size_t>(reading.end - reading.at));
    return evaluator.fail(
        reading.at, errors::kUnknownFunction,
        joined({"function ", upper(rest.substr(0, letters_in(rest))), " is not known"}));
  }
  if (last == "[" && reading.at != reading.end && *reading.at == ']') {
    return evaluator.fail(reading.at, errors::kEmptyExpression, "the expression is empty");
  }
  if (last == "=") {
    return evaluator.fail(reading.at, errors::kValueExpected,
                          joined({"a value is expected after '=', found ", found(reading)}));
  }
  return evaluator.fail(
      reading.at, errors::kOperandExpected,
      joined({"an operand is expected after ", quoted(last), ", found ", found(reading)}));
}

bool explain_not_closed(const Reading& reading) {
  Evaluator& evaluator = reading.evaluator;
  if (is_foreign_byte(reading)) {
    return explain_foreign_byte(reading);
  }
  const bool at_end = reading.at == reading.end;
  const char c = at_end ? ';' : *reading.at;
  if (c == '(' || c == ';') {
    return evaluator.fail(reading.at, errors::kBracketNotClosed,
                          joined({"']' is expected, found ", found(reading)}));
  }
  std::string message = joined({"an operator or ']' is expected, found ", found(reading)});
  if (c == '=') {
    message += " (EQ compares)";
  }
  if ((c | 0x20) == 'e' && reading.end - reading.at > 1 &&
      (is_digit(reading.at[1]) || reading.at[1] == '-')) {
    message += " (exponent notation is not allowed)";
  }
  return evaluator.fail(reading.at, errors::kOperatorExpected, std::move(message));
}

bool explain_no_bracket(const Reading& reading) {
  return reading.evaluator.fail(
      reading.at, errors::kFunctionBracket,
      joined({"'[' is expected after ", upper(before(reading)), ", found ", found(reading)}));
}

bool explain_no_variable(const Reading& reading) {
  if (is_foreign_byte(reading)) {
    return explain_foreign_byte(reading);
  }
  const std::string_view rest(reading.at, static_cast<std::size_t>(reading.end - reading.at));
  const std::string word = upper(rest.substr(0, letters_in(rest)));
  const bool beckhoff = word == "SPLINE" || word == "CONTOUR" || word == "HSC" || word == "SET" ||
                        word == "MSG" || word == "TRAFO" || word == "CS";
  return reading.evaluator.fail(
      reading.at, errors::kVariableExpected,
      joined({"a variable's number is expected after '#', found ", found(reading),
              beckhoff ? " (ISG/Beckhoff program?)" : ""}));
}

bool explain_bad_number(const Reading& reading) {
  const std::string_view rest(reading.at, static_cast<std::size_t>(reading.end - reading.at));
  const std::string_view number = rest.substr(0, rest.find_first_not_of("+-0123456789."));
  const bool digits = number.find_first_of("0123456789") != std::string_view::npos;
  return reading.evaluator.fail(reading.at, errors::kMalformedNumber,
                                joined({"malformed number ", quoted(number), ": ",
                                        digits ? "more than one decimal point" : "no digits"}));
}

}  // namespace kerf::parser
