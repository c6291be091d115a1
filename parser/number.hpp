// Decimal numbers of a part program: [sign] digits [. digits], nothing else.
#pragma once

#include <array>
#include <cstdint>

namespace kerf::parser {

struct ScannedNumber {
  double value = 0.0;
  const char* end = nullptr;  // nullptr: no number here
  bool blank_inside = false;
  bool point = false;       // has a decimal point
  bool worked_out = false;  // by the evaluator
};

// The rule that takes any number of digits and the blanks that RS274/NGC allows inside a number.
// The value is correctly rounded; too large for a double gives +-1e300, too small gives 0.
ScannedNumber scan_long_number(const char* first, const char* last);

namespace detail {

inline constexpr std::array<double, 23> kPowersOfTen = {
    1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
    1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

constexpr bool is_digit(char c) {
  return static_cast<unsigned char>(c - '0') < 10;
}
constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace detail

// Reads one number at `first`. Where mantissa and power of ten are both exact in a double (at most
// 2^53 and 10^22), their quotient is the correctly rounded value [Clinger 1990]; all other numbers
// take the long way. `end` is behind the number's last digit.
inline ScannedNumber scan_number(const char* first, const char* last) {
  using detail::is_digit;
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (at != last && (*at == '-' || *at == '+')) {
    ++at;
  }
  std::uint64_t mantissa = 0;
  const char* const digits = at;
  for (; at != last && is_digit(*at); ++at) {
    mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
  }
  auto count = at - digits;
  std::ptrdiff_t decimals = 0;
  if (at != last && *at == '.') {
    const char* const point = ++at;
    for (; at != last && is_digit(*at); ++at) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    decimals = at - point;
    count += decimals;
  }
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  const bool more = at != last && (detail::is_blank(*at) || *at == '.');
  if (count == 0 || count > 19 || mantissa > kExact) {
    return scan_long_number(first, last);
  }
  if (more) {
    const char* next = at;
    while (next != last && detail::is_blank(*next)) {
      ++next;
    }
    if (next != last && (is_digit(*next) || *next == '.')) {
      return scan_long_number(first, last);
    }
  }
  const double magnitude =
      static_cast<double>(mantissa) / detail::kPowersOfTen[static_cast<std::size_t>(decimals)];
  return {negative && mantissa != 0 ? -magnitude : magnitude, at, false, at - digits != count};
}

}  // namespace kerf::parser
