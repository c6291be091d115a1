#include "parser/flow/statement_text.hpp"

#include <algorithm>

#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

}  // namespace

std::size_t behind_label(std::string_view line, std::size_t at) {
  if (at < line.size() && line[at] == '<') {
    const std::size_t end = line.find('>', at);
    return end == std::string_view::npos ? at : end + 1;
  }
  if (at < line.size() && line[at] == '[') {
    return behind_brackets(line, at).value_or(at);
  }
  std::size_t end = at;
  for (std::size_t i = at; i < line.size() && (is_digit(line[i]) || is_blank(line[i])); ++i) {
    end = is_digit(line[i]) ? i + 1 : end;
  }
  return end;
}

std::size_t skip_blanks(std::string_view line, std::size_t at) {
  while (at < line.size() && is_blank(line[at])) {
    ++at;
  }
  return at;
}

bool is_left_out(std::string_view line, const BlockDelete& switches) {
  const std::size_t at = skip_blanks(line, 0);
  return at < line.size() && line[at] == '/' && switches.leaves_out(line, at);
}

std::size_t behind_keyword(std::string_view line, std::size_t at, std::string_view keyword) {
  for (const char wanted : keyword) {
    at = skip_blanks(line, at);
    if (at >= line.size() || detail::lower(line[at]) != detail::lower(wanted)) {
      return 0;
    }
    ++at;
  }
  return at;
}

bool only_comment_left(std::string_view line, std::size_t at) {
  at = skip_blanks(line, at);
  while (at < line.size() && line[at] == '(') {
    const std::size_t close = line.find(')', at);
    if (close == std::string_view::npos) {
      return false;
    }
    at = skip_blanks(line, close + 1);
  }
  return at >= line.size() || line[at] == ';';
}

std::optional<std::size_t> behind_brackets(std::string_view line, std::size_t at) {
  std::size_t depth = 0;
  for (std::size_t i = at; i < line.size(); ++i) {
    depth += line[i] == '[' ? 1U : 0U;
    if (line[i] == ']' && --depth == 0) {
      return i + 1;
    }
  }
  return std::nullopt;
}

BlockStart find_block_start(std::string_view line) {
  BlockStart start{skip_blanks(line, 0), std::nullopt};
  if (start.at < line.size() && line[start.at] == '/') {
    start.at = skip_blanks(line, start.at + 1);
    if (start.at < line.size() && line[start.at] >= '1' && line[start.at] <= '9') {
      start.at = skip_blanks(line, start.at + 1);
    }
  }
  if (start.at >= line.size() || detail::lower(line[start.at]) != 'n') {
    return start;
  }
  std::size_t at = skip_blanks(line, start.at + 1);
  const std::size_t digits = at;
  std::uint32_t number = 0;
  while (at < line.size() && is_digit(line[at]) && at - digits < 9) {
    number = number * 10 + static_cast<std::uint32_t>(line[at++] - '0');
  }
  const bool whole = at > digits && (at >= line.size() || (line[at] != '.' && !is_digit(line[at])));
  if (whole) {
    start = {skip_blanks(line, at), number};
  }
  return start;
}

std::string plain_label(std::string_view line, const Statement& statement) {
  const std::size_t from = statement.label_at;
  const std::string_view label = line.substr(from, behind_label(line, from) - from);
  std::string plain;
  for (const char c : label) {
    if (!is_blank(c) && !(label[0] == '<' && (c == '<' || c == '>'))) {
      plain += detail::lower(c);
    }
  }
  if (!label.empty() && is_digit(label[0])) {
    plain.erase(0, std::min(plain.find_first_not_of('0'), plain.size() - 1));
  }
  return plain;
}

std::string shown_label(std::string_view plain_label) {
  const bool bare = !plain_label.empty() && (is_digit(plain_label[0]) || plain_label[0] == '[');
  return bare ? joined({"o", plain_label}) : joined({"o<", plain_label, ">"});
}

}  // namespace kerf::parser
