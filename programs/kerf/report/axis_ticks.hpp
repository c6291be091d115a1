// Round numbers on the axes of a plot.
#pragma once

#include <vector>

namespace kerf::program {

struct ValueRange {
  double min = 0.0;
  double max = 1.0;
  [[nodiscard]] double width() const noexcept { return max - min; }
};

// The largest of 1, 2 and 5 times a power of ten that is not above the value. Precondition: it is >
// 0.
[[nodiscard]] double round_down(double value) noexcept;

// About `count` round values within the range, in ascending order; none in a range without width.
[[nodiscard]] std::vector<double> axis_ticks(const ValueRange& range, int count);

}  // namespace kerf::program
