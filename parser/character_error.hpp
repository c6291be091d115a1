// What to say about a byte that may not stand in a program.
#pragma once

#include <string>
#include <string_view>

namespace kerf::parser {

// Two or more hexadecimal digits.
std::string hex(unsigned value, int digits);

// About the character at the start of `rest`. Precondition: not empty.
std::string explain_character(std::string_view rest);

}  // namespace kerf::parser
