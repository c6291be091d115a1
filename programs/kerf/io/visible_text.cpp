#include "programs/kerf/io/visible_text.hpp"

#include <spdlog/fmt/fmt.h>

#include "diagnostics/utf8.hpp"

namespace kerf::program {

std::string visible(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const diagnostics::Utf8 character = diagnostics::utf8_at(text);
    const std::string_view bytes = text.substr(0, character.length);
    text.remove_prefix(bytes.size());
    if (!diagnostics::is_hidden(character.code)) {
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
