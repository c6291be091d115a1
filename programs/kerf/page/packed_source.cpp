#include "programs/kerf/page/packed_source.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace kerf::program {

namespace {

constexpr std::size_t kMaxDecimals = 7;
constexpr std::size_t kMaxDigits = 15;  // a double of the page holds so many

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

struct Written {
  std::int64_t value = 0;  // without its point
  std::size_t decimals = 0;
  std::size_t size = 0;  // in characters
};

// The number that the text begins with; none where it could not be written anew from its value.
std::optional<Written> number_at(std::string_view text) {
  Written number;
  const bool is_negative = !text.empty() && text.front() == '-';
  std::size_t at = is_negative ? 1 : 0;
  const std::size_t first = at;
  const auto read_digits = [&] {
    const std::size_t begin = at;
    for (; at < text.size() && is_digit(text[at]) && at - first <= kMaxDigits; ++at) {
      number.value = 10 * number.value + (text[at] - '0');
    }
    return at - begin;
  };
  const std::size_t whole = read_digits();
  if (whole == 0 || (whole > 1 && text[first] == '0')) {
    return std::nullopt;
  }
  if (at + 1 < text.size() && text[at] == '.' && is_digit(text[at + 1])) {
    ++at;
    number.decimals = read_digits();
  }
  if (whole + number.decimals > kMaxDigits || number.decimals > kMaxDecimals ||
      (is_negative && number.value == 0)) {
    return std::nullopt;
  }
  number.value = is_negative ? -number.value : number.value;
  number.size = at;
  return number;
}

}  // namespace

PackedSource packed_source(std::string_view text) {
  PackedSource packed;
  if (std::any_of(text.begin(), text.end(), [](char c) { return c >= '\1' && c <= '\10'; })) {
    packed.text = text;
    return packed;
  }
  std::array<std::array<SourceNumbers*, kMaxDecimals + 1>, 256> known{};
  for (std::size_t at = 0; at < text.size();) {
    const char before = at > 0 ? text[at - 1] : '\n';
    const auto number = is_letter(before) ? number_at(text.substr(at)) : std::nullopt;
    if (!number) {
      packed.text.push_back(text[at++]);
      continue;
    }
    SourceNumbers*& numbers = known[static_cast<unsigned char>(before)][number->decimals];
    if (numbers == nullptr) {
      numbers = &packed.numbers[before + std::to_string(number->decimals)];
    }
    numbers->numbers.add(number->value);
    ++numbers->count;
    packed.text.push_back(static_cast<char>(1 + number->decimals));
    at += number->size;
  }
  return packed;
}

}  // namespace kerf::program
