#include "programs/kerf/io/visible_text.hpp"

#include <algorithm>
#include <array>

#include <spdlog/fmt/fmt.h>

#include "diagnostics/utf8.hpp"

namespace kerf::program {

namespace {

struct Range {
  char32_t first;
  char32_t last;
};

// C0; DEL, C1 and the blank that is no blank; marks of direction and ends of lines; the byte order
// mark.
constexpr std::array kHidden{Range{0x00, 0x1F},     Range{0x7F, 0xA0},     Range{0x200E, 0x200F},
                             Range{0x2028, 0x202E}, Range{0x2066, 0x2069}, Range{0xFEFF, 0xFEFF}};

bool is_hidden(char32_t code) {
  return std::any_of(kHidden.begin(), kHidden.end(), [code](const Range& range) {
    return code >= range.first && code <= range.last;
  });
}

}  // namespace

std::string visible(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const diagnostics::Utf8 character = diagnostics::utf8_at(text);
    const std::string_view bytes = text.substr(0, character.length);
    text.remove_prefix(bytes.size());
    if (!is_hidden(character.code)) {
      shown += bytes;
      continue;
    }
    for (const char byte : bytes) {
      shown += fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
    }
  }
  return shown;
}

}  // namespace kerf::program
