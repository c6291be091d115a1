#include "profiles/trapezoid.hpp"

#include <limits>

namespace kerf::profiles {

Trapezoid Trapezoid::fastest(double /*change_mm_s*/, const RampLimits& /*limits*/) noexcept {
  return {};
}

ShapeValue Trapezoid::at(double x) const noexcept {
  return {.integral = 0.5 * x * x, .phi = x, .slope = 1.0, .curvature = 0.0};
}

double Trapezoid::peak_jerk() const noexcept {
  return std::numeric_limits<double>::infinity();
}

}  // namespace kerf::profiles
