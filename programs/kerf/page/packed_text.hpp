// Bytes as text that a page can hold.
#pragma once

#include <string>
#include <string_view>

namespace kerf::program {

// As zlib writes it (RFC 1950). Throws std::bad_alloc.
[[nodiscard]] std::string deflated(std::string_view bytes);

// RFC 4648, with '=' at the end.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace kerf::program
