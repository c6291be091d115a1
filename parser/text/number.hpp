// Decimal numbers of a part program: [sign] digits [. digits], nothing else.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace kerf::parser {

// What is odd about a number that is right.
enum class Oddity : std::uint8_t {
  none,
  blank_inside,
  fine,  // less than 1e-9, but not 0
};

struct ScannedNumber {
  double value = 0.0;
  const char* end = nullptr;  // nullptr: no number here
  Oddity oddity = Oddity::none;
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
constexpr bool is_letter(char c) {
  return static_cast<unsigned char>((c | 0x20) - 'a') < 26;
}
constexpr char to_upper(char letter) {
  return static_cast<char>(letter & ~0x20);
}
constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
}

// Takes digits at `at` into the mantissa; returns where they end.
inline const char* take_digits(const char* at, const char* last, std::uint64_t& mantissa) {
  std::uint64_t taken = mantissa;
  while (at != last) {
    const auto digit = static_cast<unsigned>(static_cast<unsigned char>(*at)) - '0';
    if (digit > 9) {
      break;
    }
    taken = taken * 10 + digit;
    ++at;
  }
  mantissa = taken;
  return at;
}

// The same where four digits in a row are usual. Each byte of a word of four is a digit if its high
// half is 3 and stays 3 when 6 is added; then pairs are joined, and pairs of pairs.
inline const char* take_decimals(const char* at, const char* last, std::uint64_t& mantissa) {
  if constexpr (std::endian::native == std::endian::little) {
    std::uint32_t four = 0;
    if (last - at >= 4) {
      std::memcpy(&four, at, 4);
      if (((four & 0xF0F0F0F0U) | (((four + 0x06060606U) & 0xF0F0F0F0U) >> 4U)) == 0x33333333U) {
        four &= 0x0F0F0F0FU;
        four = (four * 10 + (four >> 8U)) & 0x00FF00FFU;
        mantissa = mantissa * 10000 + ((four * 100 + (four >> 16U)) & 0xFFFFU);
        at += 4;
      }
    }
  }
  return take_digits(at, last, mantissa);
}

// What is odd about a value that has more than nine decimals.
Oddity oddity_of(double value);

// Whether a number goes on after the blanks at `at`, or has a second point there.
inline bool goes_on(const char* at, const char* last) {
  while (at != last && is_blank(*at)) {
    ++at;
  }
  return at != last && (is_digit(*at) || *at == '.');
}

}  // namespace detail

// Reads one number at `first`. Where mantissa and power of ten are both exact in a double (at most
// 2^53 and 10^22), their quotient is the correctly rounded value [Clinger 1990]; all other numbers
// take the long way. `end` is after the number's last digit.
inline ScannedNumber scan_number(const char* first, const char* last) {
  const char* at = first;
  bool negative = false;
  if (at != last && (*at == '-' || *at == '+')) {
    negative = *at++ == '-';
  }
  std::uint64_t mantissa = 0;
  const char* const digits = at;
  at = detail::take_digits(at, last, mantissa);
  auto count = at - digits;
  std::ptrdiff_t decimals = 0;
  bool point = false;
  if (at != last && *at == '.') {
    const char* const behind = ++at;
    at = detail::take_decimals(at, last, mantissa);
    decimals = at - behind;
    count += decimals;
    point = true;
  }
  // Fifteen digits are always below 2^53; 0 wraps to the largest.
  constexpr std::uint64_t kExact = std::uint64_t{1} << 53;
  if (static_cast<std::size_t>(count) - 1 >= 15 &&
      (count == 0 || count > 19 || mantissa > kExact)) {
    return scan_long_number(first, last);
  }
  if (at != last && (detail::is_blank(*at) || *at == '.') && detail::goes_on(at, last)) {
    return scan_long_number(first, last);
  }
  const auto whole = static_cast<std::int64_t>(mantissa);
  const double value = static_cast<double>(negative ? -whole : whole) /
                       detail::kPowersOfTen[static_cast<std::size_t>(decimals)];
  constexpr std::ptrdiff_t kUsualDecimals = 9;
  if (decimals > kUsualDecimals) [[unlikely]] {
    return {value, at, detail::oddity_of(value), point, false};
  }
  return {value, at, Oddity::none, point, false};
}

}  // namespace kerf::parser
