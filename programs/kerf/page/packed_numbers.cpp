#include "programs/kerf/page/packed_numbers.hpp"

namespace kerf::program {

void PackedNumbers::add(std::int64_t number) {
  const std::int64_t step = number - last_;
  last_ = number;
  auto rest = (static_cast<std::uint64_t>(step) << 1U) ^ static_cast<std::uint64_t>(step >> 63);
  while (rest >= 0x80U) {
    bytes_.push_back(static_cast<char>((rest & 0x7FU) | 0x80U));
    rest >>= 7U;
  }
  bytes_.push_back(static_cast<char>(rest));
}

}  // namespace kerf::program
