#include "profiles/sine.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::profiles {

Sine Sine::fastest(double /*change_mm_s*/, const RampLimits& /*limits*/) noexcept {
  return {};
}

ShapeValue Sine::at(double x) const noexcept {
  constexpr double kPi = std::numbers::pi;
  const bool second_half = x > 0.5;
  const double y = second_half ? 1.0 - x : x;
  const double half_sine = std::sin(0.5 * kPi * y);
  const double half_cosine = std::cos(0.5 * kPi * y);
  const double sine = 2.0 * half_sine * half_cosine;
  const double cosine = 1.0 - 2.0 * half_sine * half_sine;
  const ShapeValue value{.integral = std::max(0.0, 0.5 * (y - sine / kPi)),
                         .phi = half_sine * half_sine,
                         .slope = 0.5 * kPi * sine,
                         .curvature = 0.5 * kPi * kPi * cosine};
  return second_half ? mirrored(x, value) : value;
}

}  // namespace kerf::profiles
