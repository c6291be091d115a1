// Checks whether a smoothed path leaves the machine's travel.
#pragma once

#include <cstddef>

#include "curves/position.hpp"

namespace kerf::smoothing {

// Rounding at most; a path along the end of the travel stays within.
inline constexpr double kOutside_mm = 1e-9;

inline bool leaves_travel(const curves::Extents& box, const curves::Extents& travel) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.min_mm[k] < travel.min_mm[k] - kOutside_mm ||
        box.max_mm[k] > travel.max_mm[k] + kOutside_mm) {
      return true;
    }
  }
  return false;
}

}  // namespace kerf::smoothing
