#include "parser/text/number.hpp"

#include <charconv>
#include <cmath>
#include <string>
#include <system_error>

namespace kerf::parser {

namespace {

using detail::is_blank;
using detail::is_digit;

// A sign, digits and at most one point, blanks taken out.
struct Gathered {
  std::string digits;
  const char* end = nullptr;
  bool negative = false;
  bool blank_inside = false;
  bool second_point = false;
};

Gathered gather(const char* first, const char* last) {
  Gathered got;
  const char* at = first;
  if (at != last && (*at == '-' || *at == '+')) {
    got.negative = *at++ == '-';
    got.end = at;
  }
  bool point = false;
  bool blank = false;
  for (; at != last; ++at) {
    if (is_blank(*at)) {
      blank = true;
      continue;
    }
    if (!is_digit(*at) && *at != '.') {
      break;
    }
    if (*at == '.' && point) {
      got.second_point = true;
      break;
    }
    point = point || *at == '.';
    got.blank_inside = got.blank_inside || blank;
    blank = false;
    got.digits += *at;
    got.end = at + 1;
  }
  return got;
}

double convert(const std::string& digits) {
  double value = 0.0;
  const char* const end = digits.data() + digits.size();
  const auto [stopped, error] =
      std::from_chars(digits.data(), end, value, std::chars_format::fixed);
  if (error == std::errc::result_out_of_range) {
    const auto leading = digits.find_first_not_of('0');
    return leading != std::string::npos && digits[leading] != '.' ? 1e300 : 0.0;
  }
  return value;
}

}  // namespace

Oddity detail::oddity_of(double value) {
  constexpr double kResolution = 1e-9;
  return value != 0.0 && std::fabs(value) < kResolution ? Oddity::fine : Oddity::none;
}

ScannedNumber scan_long_number(const char* first, const char* last) {
  const Gathered got = gather(first, last);
  if (got.second_point || got.digits.find_first_of("0123456789") == std::string::npos) {
    return {};
  }
  const double magnitude = convert(got.digits);
  const bool point = got.digits.find('.') != std::string::npos;
  const bool zero = got.digits.find_first_of("123456789") == std::string::npos;
  // What is too small for a double is fine as well.
  const Oddity fine = zero             ? Oddity::none
                      : magnitude == 0 ? Oddity::fine
                                       : detail::oddity_of(magnitude);
  return {got.negative && magnitude != 0.0 ? -magnitude : magnitude, got.end,
          got.blank_inside ? Oddity::blank_inside : fine, point};
}

}  // namespace kerf::parser
