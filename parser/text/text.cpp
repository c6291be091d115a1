#include "parser/text/text.hpp"

#include <array>
#include <charconv>

#include "diagnostics/utf8.hpp"

namespace kerf::parser {

std::string in_mm(double value) {
  std::array<char, 400> buffer{};
  const double unsigned_zero = value > -0.0005 && value < 0.0 ? 0.0 : value;
  auto* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), unsigned_zero,
                                  std::chars_format::fixed, 3)
                        .ptr;
  return {buffer.data(), end};
}

std::string shortest(double value) {
  std::array<char, 400> buffer{};
  auto* const end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed)
          .ptr;
  return {buffer.data(), end};
}

std::string in_mm(const std::array<double, 3>& point) {
  return joined({"(", in_mm(point[0]), " ", in_mm(point[1]), " ", in_mm(point[2]), ")"});
}

std::string upper(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c != ' ' && c != '\t') {
      result += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    }
  }
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  const std::string_view begin = diagnostics::first_bytes(text, kLongest);
  std::string result = "'";
  result += begin;
  return result + (begin.size() < text.size() ? "...'" : "'");
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string result;
  for (const std::string_view part : parts) {
    result += part;
  }
  return result;
}

std::string_view named(char letter) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  return kLetters.substr(static_cast<std::size_t>(letter - 'A'), 1);
}

}  // namespace kerf::parser
