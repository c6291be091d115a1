// libFuzzer's way in.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/judge/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  kerf::fuzz::judge({data, size});
  return 0;
}
