#include "bench/part_bound.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::bench {

double spiral_bound_s(const SpiralShape& shape, double feed_mm_s, const AxisSet& axes) {
  constexpr int kPlaces = 200'000;
  const double from = shape.from_radius_mm;
  const double to = shape.to_radius_mm;
  const double length = 0.1 * shape.lines;
  const double growth = 0.5 * (to * to - from * from) / length;
  double time = 0.0;
  for (int i = 0; i < kPlaces; ++i) {
    const double s = length * (i + 0.5) / kPlaces;
    const double r = std::sqrt(from * from + 2.0 * growth * s);
    // With t = (-sin, cos) the two axes bear v^2 / r up to a (|sin| + |cos|).
    const double angle = (r - from) / growth;
    const double share = std::abs(std::sin(angle)) + std::abs(std::cos(angle));
    const double radius = std::pow(r * r + growth * growth, 1.5) / (r * r + 2.0 * growth * growth);
    time +=
        length / kPlaces / std::min(feed_mm_s, std::sqrt(axes.acceleration_mm_s2 * radius * share));
  }
  return time;
}

}  // namespace kerf::bench
