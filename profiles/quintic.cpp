#include "profiles/quintic.hpp"

namespace kerf::profiles {

Quintic Quintic::fastest(double /*change_mm_s*/, const RampLimits& /*limits*/) noexcept {
  return {};
}

ShapeValue Quintic::at(double x) const noexcept {
  const bool second_half = x > 0.5;
  const double y = second_half ? 1.0 - x : x;
  const double y2 = y * y;
  const double rest = 1.0 - y;
  const ShapeValue value{.integral = y2 * y2 * (2.5 + y * (y - 3.0)),
                         .phi = y2 * y * (10.0 + y * (6.0 * y - 15.0)),
                         .slope = 30.0 * y2 * rest * rest,
                         .curvature = 60.0 * y * rest * (1.0 - 2.0 * y)};
  return second_half ? mirrored(x, value) : value;
}

}  // namespace kerf::profiles
