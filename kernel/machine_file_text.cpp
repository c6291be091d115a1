#include "kernel/machine_file_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

namespace kerf {
namespace {

constexpr std::size_t kLongest = 64;

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

// Optimal string alignment: the Levenshtein distance with swaps of neighbours, three rows at a
// time.
std::size_t distance(std::string_view a, std::string_view b) {
  std::array<std::array<std::size_t, kLongest + 1>, 3> rows{};
  for (std::size_t j = 0; j <= b.size(); ++j) {
    rows[0][j] = j;
  }
  for (std::size_t i = 1; i <= a.size(); ++i) {
    auto& row = rows[i % 3];
    const auto& above = rows[(i + 2) % 3];
    const auto& two_above = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const bool same = lower(a[i - 1]) == lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0U : 1U)});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) &&
                           lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) {
        row[j] = std::min(row[j], two_above[j - 2] + 1);
      }
    }
  }
  return rows[a.size() % 3][b.size()];
}

}  // namespace

std::string text_of(double number) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), end.ptr};
}

std::string in_quotes(std::string_view key) {
  std::size_t length = std::min(key.size(), kLongest);
  while (length < key.size() && length > 0 && (key[length] & '\xc0') == '\x80') {
    --length;  // not within a character of UTF-8
  }
  std::string text(key.substr(0, length));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= '\0' && c < ' ') || c == '\x7f'; }, '?');
  return "'" + text + (length < key.size() ? "...'" : "'");
}

std::optional<std::string_view> nearest_word(std::string_view word,
                                             std::span<const std::string_view> known) {
  if (word.size() > kLongest) {
    return std::nullopt;
  }
  std::optional<std::string_view> nearest;
  std::size_t least = kLongest;
  for (const std::string_view candidate : known) {
    if (candidate.size() > kLongest) {
      continue;
    }
    const std::size_t changes = distance(word, candidate);
    if (changes < least && changes <= candidate.size() / 3) {
      least = changes;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace kerf
