#include "curves/curve_error.hpp"

#include <array>
#include <charconv>

namespace kerf::curves {

std::string to_text(double number) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), result.ptr};
}

std::string to_text(const Position& p_mm) {
  std::string text(1, '(');
  text.append(to_text(p_mm[0])).append(", ").append(to_text(p_mm[1]));
  return text.append(", ").append(to_text(p_mm[2])).append(")");
}

}  // namespace kerf::curves
