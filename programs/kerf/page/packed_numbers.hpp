// Numbers as few bytes.
#pragma once

#include <cstdint>
#include <string>

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

}  // namespace kerf::program
