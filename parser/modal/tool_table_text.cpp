// LinuxCNC's tool table as text.
#include <algorithm>
#include <array>
#include <cmath>

#include "parser/modal/tool_table.hpp"
#include "parser/text/letters.hpp"
#include "parser/text/number.hpp"
#include "parser/text/text.hpp"

namespace kerf::parser {

namespace {

constexpr double kLargestOffset_mm = 999999.999;

struct Mistake {
  std::size_t offset = 0;
  std::string message;
};

// The words of one line; 0 where there is none.
struct ToolLine {
  Letters present = 0;
  std::array<double, 26> values{};

  [[nodiscard]] bool has(char letter) const { return (present & letter_bit(letter)) != 0; }
  [[nodiscard]] double value(char letter) const {
    return values[static_cast<std::size_t>(letter - 'A')];
  }
};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r';
}

tl::unexpected<Mistake> mistake(std::size_t offset, std::initializer_list<std::string_view> parts) {
  return tl::unexpected(Mistake{offset, joined(parts)});
}

tl::expected<void, Mistake> check_value(char letter, double value, std::size_t offset) {
  const bool whole = letter == 'T' || letter == 'P' || letter == 'Q';
  if (whole &&
      (value != std::floor(value) || value < 0.0 || value > double{ToolTable::kHighestNumber})) {
    return mistake(offset, {named(letter), ": found ", shortest(value),
                            ", expected a whole number from 0 to 99999"});
  }
  if (letter == 'D' && value < 0.0) {
    return mistake(offset, {"D (diameter) must not be negative, found ", shortest(value)});
  }
  if (!(std::fabs(value) <= kLargestOffset_mm)) {
    return mistake(offset,
                   {named(letter), ": ", shortest(value), " is outside -999999.999..999999.999"});
  }
  if (value != 0.0 && (letter_bit(letter) & letters('A', 'B', 'C', 'U', 'V', 'W')) != 0) {
    return mistake(offset, {named(letter), ": tools have offsets along X, Y and Z only"});
  }
  return {};
}

tl::expected<ToolLine, Mistake> read_words(std::string_view text) {
  constexpr Letters kKnown =
      letters('T', 'P', 'D', 'X', 'Y', 'Z', 'I', 'J', 'Q') | letters('A', 'B', 'C', 'U', 'V', 'W');
  ToolLine line;
  for (std::size_t at = 0; at < text.size();) {
    if (is_blank(text[at])) {
      ++at;
      continue;
    }
    const std::size_t start = at;
    const char letter = static_cast<char>(text[at++] & ~0x20);
    if (letter < 'A' || letter > 'Z' || (letter_bit(letter) & kKnown) == 0) {
      return mistake(start, {"found ", quoted(text.substr(start, 1)),
                             ", expected one of T P D X Y Z I J Q or ';'"});
    }
    if (line.has(letter)) {
      return mistake(start, {named(letter), " is given twice for this tool"});
    }
    const ScannedNumber number = scan_number(text.data() + at, text.data() + text.size());
    if (number.end == nullptr) {
      return mistake(start, {"a number is expected after ", named(letter)});
    }
    at = static_cast<std::size_t>(number.end - text.data());
    if (const auto fine = check_value(letter, number.value, start); !fine) {
      return tl::unexpected(fine.error());
    }
    line.present |= letter_bit(letter);
    line.values[static_cast<std::size_t>(letter - 'A')] = number.value;
  }
  return line;
}

Tool tool_from(const ToolLine& line) {
  Tool tool;
  tool.number = static_cast<std::int32_t>(line.value('T'));
  tool.pocket = line.has('P') ? static_cast<std::int32_t>(line.value('P')) : tool.number;
  tool.offset_mm = {line.value('X'), line.value('Y'), line.value('Z')};
  tool.diameter_mm = line.value('D');
  tool.front_angle_deg = line.value('I');
  tool.back_angle_deg = line.value('J');
  tool.orientation = static_cast<std::int32_t>(line.value('Q'));
  return tool;
}

// Adds the tool of one line, if the line has any.
tl::expected<void, Mistake> read_line(std::string_view text, ToolTable& table) {
  const auto line = read_words(text.substr(0, text.find(';')));
  if (!line) {
    return tl::unexpected(line.error());
  }
  if (line->present == 0) {
    return {};
  }
  if (!line->has('T')) {
    return mistake(text.find_first_not_of(" \t"), {"T (tool number) is missing"});
  }
  const Tool tool = tool_from(*line);
  for (const Tool& other : table.listed()) {
    if (other.number == tool.number) {
      return mistake(text.find_first_of("tT"),
                     {"T", std::to_string(tool.number), " is listed twice"});
    }
  }
  table.put(tool);
  return {};
}

}  // namespace

}  // namespace kerf::parser

namespace kerf {
inline namespace v0 {

tl::expected<ToolTable, std::vector<ToolTableError>> read_tool_table(std::string_view text) {
  ToolTable table;
  table.set_given();
  std::vector<ToolTableError> errors;
  for (std::uint32_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (const auto read = parser::read_line(text.substr(0, end), table); !read) {
      errors.push_back(
          {number, static_cast<std::uint32_t>(read.error().offset) + 1, read.error().message});
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  if (!errors.empty()) {
    return tl::unexpected(std::move(errors));
  }
  return table;
}

}  // namespace v0
}  // namespace kerf
