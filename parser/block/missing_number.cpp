#include "parser/block/missing_number.hpp"

#include <array>
#include <string>

#include "diagnostics/errors/pages.hpp"
#include "parser/text/character_error.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

constexpr bool is_sign(char c) {
  return c == '-' || c == '+';
}

// The address, where its number should begin, and how a message about it does.
struct Gap {
  std::string letter;
  std::string_view rest;
  std::uint32_t at = 0;  // of rest
  std::string expected;
};

std::string dialect_hint(std::string_view name) {
  constexpr std::array<std::string_view, 6> kSiemens{"BSPLINE", "ASPLINE", "CSPLINE",
                                                     "CYCLE",   "POLY",    "CALL"};
  const bool known = std::any_of(kSiemens.begin(), kSiemens.end(), [&](std::string_view word) {
    return name.substr(0, word.size()) == word;
  });
  return known ? " (Siemens program?)" : "";
}

// What a number that cannot be read is made of: signs, digits and points up to a later sign.
struct NumberParts {
  std::size_t length = 0;
  std::size_t signs = 0;
  std::size_t points = 0;
  std::size_t digits = 0;
};

NumberParts parts_of(std::string_view rest) {
  NumberParts parts;
  for (const char c : rest) {
    const bool begun = parts.digits + parts.points > 0;
    if (!(is_digit(c) || c == '.' || (is_sign(c) && !begun))) {
      break;
    }
    ++parts.length;
    ++(is_digit(c) ? parts.digits : c == '.' ? parts.points : parts.signs);
  }
  return parts;
}

// A malformed number that begins at `rest`, or nothing where it does not look like a number.
std::string explain_malformed_number(std::string_view rest) {
  const NumberParts parts = parts_of(rest);
  if (parts.length == 0) {
    return "";
  }
  const std::string what =
      joined({"malformed number ", quoted(rest.substr(0, parts.length)), ": "});
  if (parts.signs > 1) {
    return what + "more than one sign";
  }
  if (parts.digits == 0) {
    return what + "no digits";
  }
  return what + (parts.points > 1 ? "more than one decimal point" : "not a number");
}

// Letters: words of another language, or a letter typed for a digit.
diagnostics::Fault explain_letters(const Gap& gap) {
  const std::string_view found = letters_at(gap.rest);
  const std::string hint = dialect_hint(gap.letter + upper(found));
  if (found.size() > 1 && hint.empty() && upper(found) != "OYOZO") {
    return {gap.at, joined({gap.expected, quoted(found)}), &errors::kNumberExpected};
  }
  const bool zero = gap.rest[0] == 'O' || gap.rest[0] == 'o';
  const bool one = gap.rest[0] == 'l';
  const std::string_view guess = zero ? " (zero?)" : one ? " (one?)" : std::string_view(hint);
  return {gap.at,
          joined({gap.expected, zero || one ? "the letter " : "", quoted(gap.rest.substr(0, 1)),
                  guess}),
          zero || one ? &errors::kLetterForDigit : &errors::kNumberExpected};
}

diagnostics::Fault explain_characters(const Gap& gap) {
  const std::string_view rest = gap.rest;
  if (const auto name = letters_at(rest.substr(1)); is_sign(rest[0]) && name.size() > 1) {
    return {gap.at, joined({gap.expected, quoted(rest.substr(0, name.size() + 1))}),
            &errors::kNumberExpected};
  }
  if (const std::string malformed = explain_malformed_number(rest); !malformed.empty()) {
    if (gap.letter == "N" && rest[0] == '-') {
      return {gap.at, "N: the line number must not be negative", &errors::kNegativeLineNumber};
    }
    return {gap.at, malformed, &errors::kMalformedNumber};
  }
  return detail::is_letter(rest[0]) ? explain_letters(gap) : explain_character(rest, gap.at);
}

}  // namespace

diagnostics::Fault explain_missing_number(const BlockWords& block, std::size_t letter_at) {
  const std::string_view line = block.line;
  std::size_t at = letter_at + 1;
  while (at < line.size() && is_blank(line[at])) {
    ++at;
  }
  const std::string letter = upper(line.substr(letter_at, 1));
  const Gap gap{letter, line.substr(at), static_cast<std::uint32_t>(at),
                joined({"a number is expected after address '", letter, "', found "})};
  const auto here = static_cast<std::uint32_t>(letter_at);
  if (gap.rest.empty()) {
    return {here, gap.expected + "the end of the line", &errors::kNumberExpected};
  }
  if (gap.rest[0] == '(' || gap.rest[0] == ';') {
    return {gap.at, gap.expected + "a comment (expressions stand in [ ])",
            &errors::kNumberExpected};
  }
  if (letter == "O" && gap.rest[0] == '<') {
    return {here, "an o-word must be the first word of a block", &errors::kOWordNotFirst};
  }
  return explain_characters(gap);
}

}  // namespace kerf::parser
