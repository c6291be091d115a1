// Words for messages about a machine file.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace kerf {

// The shortest text that reads back as the same number, whatever the locale.
std::string text_of(double number);

// A key of the file in quotes: on one line, of bounded length, without control characters.
std::string in_quotes(std::string_view key);

// The known word with the smallest edit distance to `word` (changed, missing and extra characters
// and swapped neighbours count 1; case does not count). Nothing if the distance exceeds a third of
// the known word's length, or `word` is longer than 64 characters.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace kerf
