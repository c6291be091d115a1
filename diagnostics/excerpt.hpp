// A line of the program, or a part of it, in a form that can be shown.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::diagnostics {

struct Excerpt {
  std::string text;              // valid UTF-8, without tabs and control characters
  std::uint32_t caret = 0;       // columns before the place, as a terminal shows the text
  std::uint32_t characters = 0;  // of the whole line before the place
};

// What to show of `line` for the byte at `offset` (at most its length). Of a long line it is some
// hundred bytes round the place, with "..." where more was left out. A tab becomes one blank, and
// what is no character becomes U+FFFD; where that is a third of it or more there is no text.
Excerpt excerpt_of(std::string_view line, std::uint32_t offset);

}  // namespace kerf::diagnostics
