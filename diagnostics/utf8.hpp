// Characters of UTF-8 text that may not be UTF-8 at all.
#pragma once

#include <cstddef>
#include <string_view>

namespace kerf::diagnostics {

struct Utf8 {
  char32_t code = 0;       // 0: a byte that is no character, or NUL
  std::size_t length = 1;  // in bytes, at least 1
};

// The character at the start of `bytes`. Precondition: not empty.
Utf8 utf8_at(std::string_view bytes);

// The longest begin of at most so many bytes that cuts no character.
std::string_view first_bytes(std::string_view bytes, std::size_t most);

// Shows nothing of itself, or changes how a terminal shows what follows: control characters, marks
// of direction, ends of lines, the byte order mark, the blank that is no blank.
bool is_hidden(char32_t code);

}  // namespace kerf::diagnostics
