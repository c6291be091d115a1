// Which known word a misspelt one was meant to be.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace kerf {

// The known word that the fewest changed, missing, surplus or swapped neighbouring characters turn
// into `word` (upper and lower case count as one). Nothing where that takes more than a third of
// the known word's length, or where the word is longer than 64 characters.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace kerf
