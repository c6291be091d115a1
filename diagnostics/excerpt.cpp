#include "diagnostics/excerpt.hpp"

#include <algorithm>
#include <array>

#include "diagnostics/utf8.hpp"

namespace kerf::diagnostics {

namespace {

constexpr std::size_t kBefore = 60;
constexpr std::size_t kBehind = 40;
constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
constexpr std::string_view kLeftOut = "...";

struct Range {
  char32_t first;
  char32_t last;
};

// What terminals show two columns wide, by and large (Unicode Standard Annex 11: wide, full width).
constexpr std::array kWide{Range{0x1100, 0x115F},  Range{0x2E80, 0x303E}, Range{0x3041, 0xA4CF},
                           Range{0xAC00, 0xD7A3},  Range{0xF900, 0xFAFF}, Range{0xFE30, 0xFE6F},
                           Range{0xFF00, 0xFF60},  Range{0xFFE0, 0xFFE6}, Range{0x1F300, 0x1FAFF},
                           Range{0x20000, 0x3FFFD}};
// Marks that are put over the character before: no column of their own.
constexpr std::array kCombining{Range{0x0300, 0x036F}, Range{0x200B, 0x200D}, Range{0x20D0, 0x20FF},
                                Range{0xFE00, 0xFE0F}};

template <std::size_t kSize>
bool is_in(const std::array<Range, kSize>& ranges, char32_t code) {
  return std::any_of(ranges.begin(), ranges.end(), [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

std::uint32_t columns_of(char32_t code) {
  return is_in(kCombining, code) ? 0 : is_in(kWide, code) ? 2 : 1;
}

// `at`, or the start of the character that it is inside.
std::size_t start_of_character(std::string_view line, std::size_t at) {
  for (std::size_t back = 1; back < 4 && back <= at; ++back) {
    if (utf8_at(line.substr(at - back)).length > back) {
      return at - back;
    }
  }
  return at;
}

std::uint32_t characters_before(std::string_view line, std::size_t place) {
  std::uint32_t count = 0;
  for (std::size_t at = 0; at < place;) {
    at += utf8_at(line.substr(at)).length;
    count += at <= place ? 1 : 0;
  }
  return count;
}

}  // namespace

Excerpt excerpt_of(std::string_view line, std::uint32_t offset) {
  const std::size_t place = std::min<std::size_t>(offset, line.size());
  const std::size_t begin =
      place > kBefore + kLeftOut.size() ? start_of_character(line, place - kBefore) : 0;
  const std::size_t end = line.size() - place > kBehind + kLeftOut.size()
                              ? start_of_character(line, place + kBehind)
                              : line.size();
  Excerpt excerpt;
  excerpt.characters = characters_before(line, place);
  std::uint32_t column = 0;
  std::size_t unreadable = 0;
  const auto show = [&](std::string_view text, std::uint32_t columns) {
    excerpt.text += text;
    column += columns;
  };
  if (begin > 0) {
    show(kLeftOut, kLeftOut.size());
  }
  for (std::size_t at = begin; at < end;) {
    const Utf8 character = utf8_at(line.substr(at));
    if (at <= place) {
      excerpt.caret = column;
    }
    if (character.code == '\t') {
      show(" ", 1);
    } else if (is_hidden(character.code)) {
      show(kReplacement, 1);
      ++unreadable;
    } else {
      show(line.substr(at, character.length), columns_of(character.code));
    }
    at += character.length;
  }
  if (place >= end) {
    excerpt.caret = column;
  }
  if (end < line.size()) {
    show(kLeftOut, kLeftOut.size());
  }
  if (unreadable * 3 > end - begin) {
    excerpt.text.clear();  // binary data: there is nothing to see
  }
  excerpt.text.erase(excerpt.text.find_last_not_of(' ') + 1);
  return excerpt;
}

}  // namespace kerf::diagnostics
