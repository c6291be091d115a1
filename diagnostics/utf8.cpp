#include "diagnostics/utf8.hpp"

#include <algorithm>
#include <array>

namespace kerf::diagnostics {

namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// C0; DEL, C1 and the blank that is no blank; marks of direction and ends of lines; the byte order
// mark.
constexpr std::array kHidden{Range{0x00, 0x1F},     Range{0x7F, 0xA0},     Range{0x200E, 0x200F},
                             Range{0x2028, 0x202E}, Range{0x2066, 0x2069}, Range{0xFEFF, 0xFEFF}};

}  // namespace

std::string_view first_bytes(std::string_view bytes, std::size_t most) {
  constexpr std::size_t kMostOfCharacter = 4;
  if (bytes.size() <= most) {
    return bytes;
  }
  const auto goes_on = [bytes](std::size_t at) {
    return (static_cast<unsigned char>(bytes[at]) & 0xC0U) == 0x80U;
  };
  std::size_t size = most;
  while (size > 0 && most - size < kMostOfCharacter && goes_on(size)) {
    --size;
  }
  return bytes.substr(0, goes_on(size) ? most : size);
}

bool is_hidden(char32_t code) {
  return std::ranges::any_of(
      kHidden, [code](const Range& range) { return code >= range.first && code <= range.last; });
}

Utf8 utf8_at(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) {
    return {lead, 1};
  }
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || bytes.size() < length) {
    return {};
  }
  char32_t code = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) {
      return {};
    }
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  return overlong || surrogate || code > 0x10FFFF ? Utf8{} : Utf8{code, length};
}

}  // namespace kerf::diagnostics
