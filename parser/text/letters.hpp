// Sets of address letters.
#pragma once

#include <cstdint>

namespace kerf::parser {

// Letters as a set, one bit each.
using Letters = std::uint32_t;
constexpr Letters letter_bit(char upper_case) {
  return Letters{1} << (upper_case - 'A');
}
template <class... Char>
constexpr Letters letters(Char... upper_case) {
  return (letter_bit(upper_case) | ...);
}
inline constexpr Letters kAxisLetters = letters('X', 'Y', 'Z');

}  // namespace kerf::parser
