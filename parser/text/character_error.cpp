#include "parser/text/character_error.hpp"

#include <array>
#include <cstdio>

#include "diagnostics/errors/pages.hpp"
#include "diagnostics/utf8.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

std::string hex(unsigned value, int digits) {
  std::array<char, 16> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%0*X", digits, value);
  return buffer.data();
}

namespace {

diagnostics::Fault explain_non_ascii(std::string_view rest, std::uint32_t offset) {
  const auto [code, length] = diagnostics::utf8_at(rest);
  if (code == 0) {
    return {offset,
            joined({"byte 0x", hex(static_cast<unsigned char>(rest[0]), 2),
                    " is not allowed outside a comment"}),
            &errors::kBadEncoding};
  }
  const std::string shown = joined({"'", rest.substr(0, length), "' (U+", hex(code, 4), ")"});
  if (code == 0x2212 || (code >= 0x2010 && code <= 0x2015)) {
    return {offset, shown + " is not a minus sign: use '-'", &errors::kNotAMinus};
  }
  if (code == 0xA0) {
    return {offset,
            "bytes 0xC2 0xA0 (no-break space) are not allowed outside a comment: use a blank",
            &errors::kNoBreakSpace};
  }
  return {offset, "non-ASCII character " + shown + " is not allowed outside a comment",
          &errors::kNonAscii};
}

}  // namespace

diagnostics::Fault explain_character(std::string_view rest, std::uint32_t offset) {
  const char c = rest[0];
  if (static_cast<unsigned char>(c) >= 0x80) {
    return explain_non_ascii(rest, offset);
  }
  if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
    return {offset, joined({"byte 0x", hex(static_cast<unsigned char>(c), 2), " is not allowed"}),
            &errors::kControlByte};
  }
  const std::string_view shown = rest.substr(0, 1);
  const std::string not_here = joined({"character '", shown, "' is not allowed here"});
  switch (c) {
    case '#':
      return {offset, "'#' begins a value: the letter that it belongs to is expected before it",
              &errors::kMisplacedExpression};
    case '[':
      return {offset, "'[' begins a value: the letter that it belongs to is expected before it",
              &errors::kMisplacedExpression};
    case ']':
      return {offset, "']' without '['", &errors::kMisplacedExpression};
    case ')':
      return {offset, "')' without '('", &errors::kUnmatchedParenthesis};
    case '/':
      return {offset, "'/' is allowed only at the start of a block", &errors::kMisplacedSlash};
    case '%':
      return {offset, "'%' must stand alone on its line", &errors::kMisplacedPercent};
    case '=':
      return {offset, not_here + " (Siemens program?)", &errors::kForeignSyntax};
    case '*':
      return {offset, not_here + " (3D-printer checksum?)", &errors::kForeignSyntax};
    case '$':
      return {offset, not_here + " (grbl command?)", &errors::kForeignSyntax};
    default:
      return {offset, not_here, &errors::kMisplacedCharacter};
  }
}

}  // namespace kerf::parser
