#include "parser/block/lexical_error.hpp"

#include <algorithm>
#include <array>

#include "diagnostics/errors/pages.hpp"
#include "parser/block/missing_number.hpp"
#include "parser/text/character_error.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

constexpr bool is_sign_or_point(char c) {
  return c == '-' || c == '+' || c == '.';
}

// Words of macro programs, which the grammar takes for addresses.
bool is_macro_word(const std::string& word) {
  constexpr std::array<std::string_view, 6> kKnown{"IF", "THEN", "GOTO", "WHILE", "DO", "END"};
  return std::any_of(kKnown.begin(), kKnown.end(), [&](std::string_view name) {
    return word == name || (name == "IF" && word.rfind(name, 0) == 0);
  });
}

diagnostics::Fault explain_comment(const BlockWords& block, std::size_t at) {
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

diagnostics::Fault explain_letter(const BlockWords& block, std::size_t at) {
  const char letter = static_cast<char>(block.line[at] & ~0x20);
  const auto offset = static_cast<std::uint32_t>(at);
  if (block.stop == Stop::repeated) {
    return {offset, joined({named(letter), " is given twice in this block"}),
            &errors::kRepeatedWord};
  }
  if (block.stop == Stop::too_many_g) {
    return {
        offset,
        joined({"too many G codes in one block (at most ", std::to_string(BlockWords::kMaxG), ")"}),
        &errors::kTooManyGCodes};
  }
  if (block.stop == Stop::too_many_m) {
    return {
        offset,
        joined({"too many M codes in one block (at most ", std::to_string(BlockWords::kMaxM), ")"}),
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
diagnostics::Fault explain_after_number(const BlockWords& block, std::size_t at) {
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
diagnostics::Fault explain_corner(std::string_view line, std::size_t at) {
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

// What is left: parts of numbers where no number can be, and what no block has.
diagnostics::Fault explain_beside_number(const BlockWords& block, std::size_t at) {
  const std::string_view line = block.line;
  const char c = line[at];
  const std::size_t open =
      is_digit(c) && at > 0 ? comment_in_number(line, at) : std::string_view::npos;
  if (open != std::string_view::npos) {
    return {static_cast<std::uint32_t>(open),
            joined({"a comment splits a number: ", quoted(line.substr(open - 1, at + 2 - open))}),
            &errors::kCommentInNumber};
  }
  const bool after_number = at > 0 && (is_digit(line[at - 1]) || line[at - 1] == '.');
  if (after_number && (c == ',' || is_sign_or_point(c))) {
    return explain_after_number(block, at);
  }
  if (is_digit(c) || is_sign_or_point(c)) {
    return {static_cast<std::uint32_t>(at), "an address letter is expected before a number",
            &errors::kAddressExpected};
  }
  return explain_character(line.substr(at), static_cast<std::uint32_t>(at));
}

}  // namespace

diagnostics::Fault explain_stop(const BlockWords& block) {
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
  if (detail::is_letter(c)) {
    return explain_letter(block, at);
  }
  if (c == ',' && at + 1 < line.size() && detail::is_letter(line[at + 1])) {
    return explain_corner(line, at);
  }
  return explain_beside_number(block, at);
}

}  // namespace kerf::parser
