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

// The known word that the fewest changed, missing, surplus or swapped neighbouring characters turn
// into `word` (upper and lower case count as one). Nothing where that takes more than a third of
// the known word's length, or where the word is longer than 64 characters.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace kerf
