// Sets of address letters.
#pragma once

#include <kerf/program_data.hpp>

namespace kerf::parser {

using kerf::letter_bit;
using kerf::Letters;

template <class... Char>
constexpr Letters letters(Char... upper_case) {
  return (letter_bit(upper_case) | ...);
}
inline constexpr Letters kAxisLetters = letters('X', 'Y', 'Z');

}  // namespace kerf::parser
