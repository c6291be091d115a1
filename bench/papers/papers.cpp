#include "bench/papers/papers.hpp"

#include <algorithm>
#include <array>

namespace kerf::bench {

int papers() {
  const std::array parts{sigmoid_butterfly(), sigmoid_wm(), sine_series(), quintic()};
  return std::ranges::all_of(parts, [](bool holds) { return holds; }) ? 0 : 1;
}

}  // namespace kerf::bench
