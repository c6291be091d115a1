// A program's text with its numbers apart, which packs to a small part: docs/page-data.md.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "programs/kerf/page/packed_numbers.hpp"

namespace kerf::program {

// Numbers that follow one letter and have as many decimals, in the order of the text.
struct SourceNumbers {
  PackedNumbers numbers;
  std::size_t count = 0;
};

struct PackedSource {
  // A number is one byte in it: 1 more than its decimals.
  std::string text;
  // By name: the letter and the decimals, "X3".
  std::map<std::string, SourceNumbers> numbers;
};

// Only numbers that are written as they would be from their value and their decimals go apart, and
// none of a text that has bytes 1 to 8 itself.
[[nodiscard]] PackedSource packed_source(std::string_view text);

}  // namespace kerf::program
