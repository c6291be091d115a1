// Words for messages about a machine file.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <kerf/program_data.hpp>

namespace kerf {

// The shortest text that reads back as the same number, whatever the locale.
std::string text_of(double number);

// A key of the file in quotes: on one line, of bounded length, without control characters.
std::string in_quotes(std::string_view key);

// "G61", "G61.1", or "G64" with P and Q or without, in mm from 0 to 1000, as a program writes them:
// "G64 P0.02 Q0.01". What is missing is as in a program (ProgramData's tolerances; P alone counts
// for both). Nothing: it is none of these.
std::optional<PathControl> path_control_of(std::string_view words, const ProgramData& machine);

// The known word with the smallest edit distance to `word` (changed, missing and extra characters
// and swapped neighbours count 1; case does not count). Nothing if the distance exceeds a third of
// the known word's length, or `word` is longer than 64 characters.
std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known);

}  // namespace kerf
