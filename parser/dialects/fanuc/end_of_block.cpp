#include "parser/dialects/fanuc/fanuc_codes.hpp"
#include "parser/text/number.hpp"

namespace kerf::parser {

namespace {

bool begins_value(char c) {
  return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == '#' || c == '[';
}

bool is_of_value(char c) {
  return begins_value(c) || c == ']' || c == '*' || c == '/' || c == '=';
}

}  // namespace

bool reads_as_block(std::string_view text) {
  constexpr std::string_view kBlanks = " \t";
  bool any = false;
  for (std::size_t at = 0; at < text.size() && text[at] != ';' && text[at] != '('; ++at) {
    const char c = text[at];
    if (detail::is_letter(c)) {
      const std::size_t value = text.find_first_not_of(kBlanks, at + 1);
      if (value == std::string_view::npos || !begins_value(text[value])) {
        return false;
      }
      any = true;
    } else if (is_of_value(c)) {
      any = any || c == '#';
      if (!any) {
        return false;
      }
    } else if (kBlanks.find(c) == std::string_view::npos) {
      return false;
    }
  }
  return any;
}

}  // namespace kerf::parser
