// Feedrates as colours.
#pragma once

#include <cstddef>
#include <string>

namespace kerf::program {

inline constexpr std::size_t kColourLevels = 32;

// The level of v_mm_s between 0 and max_mm_s; clamped, 0 where max_mm_s is 0.
[[nodiscard]] std::size_t colour_level(double v_mm_s, double max_mm_s) noexcept;

// "#0d0887". level < kColourLevels, 0 is slow. The colours are those of matplotlib's `plasma`
// (Smith, van der Walt, Firing; CC0) without its yellow end, which does not show on white: even
// steps to the eye, also for the colour-blind and in print.
[[nodiscard]] std::string colour_of(std::size_t level);

}  // namespace kerf::program
