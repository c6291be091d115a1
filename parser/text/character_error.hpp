// What to say about a byte that may not stand in a program.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "diagnostics/fault.hpp"

namespace kerf::parser {

// Two or more hexadecimal digits.
std::string hex(unsigned value, int digits);

// About the character at the start of `rest`, which is `offset` bytes into its line.
// Precondition: not empty.
diagnostics::Fault explain_character(std::string_view rest, std::uint32_t offset);

}  // namespace kerf::parser
