#include "tests/kernel/printed_words.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace kerf::test {

double print_number(double x, std::string& text) {
  std::array<char, 40> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.7f", x);
  text += buffer.data();
  return std::strtod(buffer.data(), nullptr);
}

Vec print_axes(const Vec& to_mm, std::string& text) {
  Vec printed{};
  for (std::size_t k = 0; k < 3; ++k) {
    text += std::string(" ") + "XYZ"[k];
    printed[k] = print_number(to_mm[k], text);
  }
  return printed;
}

}  // namespace kerf::test
