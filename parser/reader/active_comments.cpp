#include "parser/reader/active_comments.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "parser/expressions/evaluator.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using Kind = ProgramMessage::Kind;

struct Opening {
  std::string_view word;
  std::optional<Kind> kind;
};
constexpr std::array<Opening, 4> kOpenings{{{"ABORT,", std::nullopt},
                                            {"MSG,", Kind::message},
                                            {"PRINT,", Kind::print},
                                            {"DEBUG,", Kind::debug}}};

std::string six_decimals(double value) {
  std::array<char, 400> digits{};  // 1e308 has 309 before the point
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), value,
                                     std::chars_format::fixed, 6);
  return {digits.data(), written.ptr};
}

// Of one that cannot be read.
std::size_t end_of_variable(std::string_view text, std::size_t begin) {
  std::size_t end = begin + 1;
  if (end < text.size() && text[end] == '<') {
    return std::min(text.find('>', end), text.size() - 1) + 1;
  }
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') {
    ++end;
  }
  return end;
}

}  // namespace

std::optional<ActiveComment> active_comment(std::string_view comment) {
  const std::size_t comma = comment.find(',');
  const std::size_t end = std::min(comment.find(')'), comment.size());
  if (comma == std::string_view::npos || comma > end) {
    return std::nullopt;
  }
  const std::string word = upper(comment.substr(0, comma + 1));
  const auto* const opening = std::ranges::find(kOpenings, word, &Opening::word);
  if (opening == kOpenings.end()) {
    return std::nullopt;
  }
  const std::string_view text = comment.substr(comma + 1, end - comma - 1);
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  return ActiveComment{.kind = opening->kind, .text = text.substr(begin)};
}

std::string message_text(const ActiveComment& comment, Parameters& parameters) {
  if (comment.kind == Kind::message) {
    return std::string(comment.text);
  }
  std::string text;
  Evaluator evaluator(parameters);  // the block's own keeps its assignments
  for (Cursor at{.line = comment.text}; at.at < at.line.size();) {
    if (at.line[at.at] != '#') {
      text += at.line[at.at++];
      continue;
    }
    const std::size_t begin = at.at;
    double value = 0.0;
    evaluator.begin_line();
    if (evaluator.read_value(at, value)) {
      text += six_decimals(value);
    } else {
      text += "######";
      at.at = end_of_variable(at.line, begin);
    }
  }
  return text;
}

}  // namespace kerf::parser
