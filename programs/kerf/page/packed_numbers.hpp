// Numbers as few bytes, and bytes as text.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace kerf::program {

// Whole numbers as their differences, each in 7 bits a byte, the lowest first (LEB128); the sign
// is in the lowest bit (zigzag).
class PackedNumbers {
 public:
  void add(std::int64_t number);
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
  std::int64_t last_ = 0;
};

// As zlib writes it (RFC 1950). Throws std::bad_alloc.
[[nodiscard]] std::string deflated(std::string_view bytes);

// RFC 4648, with '=' at the end.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace kerf::program
