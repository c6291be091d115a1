#include "parser/lexical_error.hpp"

#include <algorithm>
#include <initializer_list>

#include "parser/character_error.hpp"
#include "parser/errors/characters.hpp"
#include "parser/errors/flow.hpp"
#include "parser/errors/variables.hpp"
#include "parser/errors/words.hpp"
#include "parser/number.hpp"
#include "parser/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

constexpr bool is_letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}

std::string_view letters_at(std::string_view rest) {
  return rest.substr(0, static_cast<std::size_t>(
                            std::find_if_not(rest.begin(), rest.end(), is_letter) - rest.begin()));
}

std::string dialect_hint(const std::string& name) {
  for (const char* const known : {"BSPLINE", "ASPLINE", "CSPLINE", "CYCLE", "POLY", "CALL"}) {
    if (name.rfind(known, 0) == 0) {
      return " (Siemens program?)";
    }
  }
  return "";
}

// A malformed number that begins at `rest`, or nothing where it does not look like a number.
std::string explain_malformed_number(std::string_view rest) {
  std::size_t length = 0;
  std::size_t signs = 0;
  std::size_t points = 0;
  bool digits = false;
  for (; length < rest.size(); ++length) {
    const char c = rest[length];
    if (c != '-' && c != '+' && c != '.' && !is_digit(c)) {
      break;
    }
    if ((c == '-' || c == '+') && (digits || points > 0)) {
      break;
    }
    signs += c == '-' || c == '+' ? 1 : 0;
    points += c == '.' ? 1 : 0;
    digits = digits || is_digit(c);
  }
  if (length == 0) {
    return "";
  }
  const std::string what = joined({"malformed number ", quoted(rest.substr(0, length)), ": "});
  if (signs > 1) {
    return what + "more than one sign";
  }
  if (!digits) {
    return what + "no digits";
  }
  return what + (points > 1 ? "more than one decimal point" : "not a number");
}

// What stands after address `letter` where its number should be.
Fault explain_missing_number(const Block& block, std::size_t letter_at) {
  const std::string_view line = block.line;
  std::size_t at = letter_at + 1;
  while (at < line.size() && is_blank(line[at])) {
    ++at;
  }
  const std::string_view rest = line.substr(at);
  const std::string letter = upper(line.substr(letter_at, 1));
  const std::string expected =
      joined({"a number is expected after address '", letter, "', found "});
  const auto here = static_cast<std::uint32_t>(letter_at);
  const auto there = static_cast<std::uint32_t>(at);
  if (rest.empty()) {
    return {here, expected + "the end of the line", &errors::kNumberExpected};
  }
  if (rest[0] == '(' || rest[0] == ';') {
    return {there, expected + "a comment (expressions stand in [ ])", &errors::kNumberExpected};
  }
  if (letter == "O" && rest[0] == '<') {
    return {here, "an o-word must be the first word of a block", &errors::kOWordNotFirst};
  }
  const bool sign = rest[0] == '-' || rest[0] == '+';
  if (const auto name = letters_at(rest.substr(sign ? 1 : 0)); sign && name.size() > 1) {
    return {there, joined({expected, quoted(rest.substr(0, name.size() + 1))}),
            &errors::kNumberExpected};
  }
  if (const std::string malformed = explain_malformed_number(rest); !malformed.empty()) {
    if (letter == "N" && rest[0] == '-') {
      return {there, "N: the line number must not be negative", &errors::kNegativeLineNumber};
    }
    return {there, malformed, &errors::kMalformedNumber};
  }
  if (!is_letter(rest[0])) {
    return explain_character(rest, there);
  }
  const std::string_view found = letters_at(rest);
  const std::string hint = dialect_hint(letter + upper(found));
  if (found.size() > 1 && hint.empty() && upper(found) != "OYOZO") {
    return {there, joined({expected, quoted(found)}), &errors::kNumberExpected};
  }
  const bool zero = rest[0] == 'O' || rest[0] == 'o';
  const bool one = rest[0] == 'l';
  const std::string_view guess = zero ? " (zero?)" : one ? " (one?)" : std::string_view(hint);
  return {there,
          joined({expected, zero || one ? "the letter " : "", quoted(rest.substr(0, 1)), guess}),
          zero || one ? &errors::kLetterForDigit : &errors::kNumberExpected};
}

// Words of macro programs, which the grammar takes for addresses.
bool is_macro_word(const std::string& word) {
  for (const char* const known : {"IF", "THEN", "GOTO", "WHILE", "DO", "END"}) {
    const std::string_view name(known);
    if (word.rfind(name, 0) == 0 && (word.size() == name.size() || name == "IF")) {
      return true;
    }
  }
  return false;
}

Fault explain_comment(const Block& block, std::size_t at) {
  for (std::size_t i = at + 1; i < block.line.size(); ++i) {
    if (block.line[i] == '(') {
      return {static_cast<std::uint32_t>(i), "'(' inside a comment", &errors::kNestedComment};
    }
    if (block.line[i] == '\0') {
      return {static_cast<std::uint32_t>(i), "byte 0x00 is not allowed", &errors::kControlByte};
    }
  }
  return {static_cast<std::uint32_t>(at), "the comment opened here is not closed on this line",
          &errors::kUnclosedComment};
}

Fault explain_letter(const Block& block, std::size_t at) {
  const char letter = static_cast<char>(block.line[at] & ~0x20);
  const auto offset = static_cast<std::uint32_t>(at);
  if (block.stop == Stop::repeated) {
    return {offset, joined({named(letter), " is given twice in this block"}),
            &errors::kRepeatedWord};
  }
  if (block.stop == Stop::too_many_g) {
    return {offset,
            joined({"too many G codes in one block (at most ", std::to_string(Block::kMaxG), ")"}),
            &errors::kTooManyGCodes};
  }
  if (block.stop == Stop::too_many_m) {
    return {offset,
            joined({"too many M codes in one block (at most ", std::to_string(Block::kMaxM), ")"}),
            &errors::kTooManyMCodes};
  }
  const std::string_view word = letters_at(block.line.substr(at));
  if (upper(word) == "THEN") {
    return {offset, "THEN without IF [..] before it", &errors::kMacroStatement};
  }
  if (is_macro_word(upper(word))) {
    return {offset,
            joined({upper(word),
                    " is a statement of the Fanuc dialect (--dialect fanuc); "
                    "RS274/NGC has o-words"}),
            &errors::kMacroStatement};
  }
  if (letter == 'N' && at + 1 < block.line.size() && is_digit(block.line[at + 1])) {
    return {
        offset,
        block.has('N') ? "N is given twice in this block" : "N must be the first word of a block",
        block.has('N') ? &errors::kRepeatedWord : &errors::kLineNumberNotFirst};
  }
  return explain_missing_number(block, at);
}

// A character straight after a number that cannot go on there.
Fault explain_after_number(const Block& block, std::size_t at) {
  std::size_t start = at;
  while (start > 0 && (is_digit(block.line[start - 1]) || block.line[start - 1] == '.')) {
    --start;
  }
  const char c = block.line[at];
  std::string message = joined({"unexpected character '", block.line.substr(at, 1),
                                "' after number ", block.line.substr(start, at - start)});
  if (c == ',') {
    message += " (the decimal separator is '.')";
  }
  return {static_cast<std::uint32_t>(at), message, &errors::kUnexpectedAfterNumber};
}

// Fanuc's chamfers and roundings: ',C2' and ',R2'.
Fault explain_corner(std::string_view line, std::size_t at) {
  const std::string word = upper(line.substr(at, 2));
  const bool known = word == ",C" || word == ",R";
  return {static_cast<std::uint32_t>(at),
          joined({"'", word, "': ",
                  known ? "chamfers and roundings of corners are not supported"
                        : "a comma may not stand before a word"}),
          &errors::kCornerWord};
}

// Where the comment opened that stands between two digits, the second of them at `at`.
std::size_t comment_in_number(std::string_view line, std::size_t at) {
  const std::size_t open = line[at - 1] == ')' ? line.rfind('(', at) : std::string_view::npos;
  const bool digit_before = open != std::string_view::npos && open > 0 && is_digit(line[open - 1]);
  return digit_before ? open : std::string_view::npos;
}

// Whether an operator at `at` follows a value that is no plain number of a word: #1, [..], #<name>
// or what was assigned.
bool is_operator_behind_value(std::string_view line, std::size_t at) {
  constexpr std::string_view kOperators = "+-*/";
  if (kOperators.find(line[at]) == std::string_view::npos) {
    return false;
  }
  std::size_t end = at;
  while (end > 0 && is_blank(line[end - 1])) {
    --end;
  }
  std::size_t start = end;
  while (start > 0 && (is_digit(line[start - 1]) || line[start - 1] == '.')) {
    --start;
  }
  const std::size_t before = line.find_last_not_of(" \t+-", start == 0 ? 0 : start - 1);
  const char c = start == 0 || before == std::string_view::npos ? ' ' : line[before];
  return start < end ? c == '#' || c == '=' : c == ']' || c == '>';
}

}  // namespace

Fault explain_stop(const Block& block) {
  if (block.stop == Stop::value) {
    return *block.fault;
  }
  const std::size_t at = block.stopped_at;
  const std::string_view line = block.line;
  const char c = line[at];
  if (c == '(') {
    return explain_comment(block, at);
  }
  if (is_operator_behind_value(line, at)) {
    return {static_cast<std::uint32_t>(at),
            joined({"operator '", line.substr(at, 1),
                    "' outside of brackets: an expression stands in [ ]"}),
            &errors::kOperatorOutsideBrackets};
  }
  if (is_letter(c)) {
    return explain_letter(block, at);
  }
  if (is_digit(c) && at > 0) {
    if (const std::size_t open = comment_in_number(line, at); open != std::string_view::npos) {
      return {static_cast<std::uint32_t>(open),
              joined({"a comment splits a number: ", quoted(line.substr(open - 1, at + 2 - open))}),
              &errors::kCommentInNumber};
    }
  }
  const bool after_number = at > 0 && (is_digit(line[at - 1]) || line[at - 1] == '.');
  if (after_number && (c == ',' || c == '-' || c == '+' || c == '.')) {
    return explain_after_number(block, at);
  }
  if (c == ',' && at + 1 < line.size() && is_letter(line[at + 1])) {
    return explain_corner(line, at);
  }
  if (is_digit(c) || c == '-' || c == '+' || c == '.') {
    return {static_cast<std::uint32_t>(at), "an address letter is expected before a number",
            &errors::kAddressExpected};
  }
  return explain_character(line.substr(at), static_cast<std::uint32_t>(at));
}

}  // namespace kerf::parser
