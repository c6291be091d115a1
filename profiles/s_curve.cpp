#include "profiles/s_curve.hpp"

#include <algorithm>
#include <cmath>

#include "profiles/reach.hpp"

namespace kerf::profiles {

SCurve::SCurve(double jerk_share) noexcept : jerk_share_(std::clamp(jerk_share, 0.0, 0.5)) {}

SCurve SCurve::fastest(double change_mm_s, const RampLimits& limits) noexcept {
  if (std::isinf(limits.jerk_mm_s3)) {
    return SCurve{0.0};
  }
  const double jerk_phase_s = limits.acceleration_mm_s2 / limits.jerk_mm_s3;
  if (!(std::abs(change_mm_s) > limits.acceleration_mm_s2 * jerk_phase_s)) {
    return SCurve{0.5};
  }
  return SCurve{jerk_phase_s / s_curve_duration_s(change_mm_s, limits)};
}

ShapeValue SCurve::at(double x) const noexcept {
  const double share = jerk_share_;
  const double peak = 1.0 / (1.0 - share);
  const bool second_half = x > 0.5;
  const double y = second_half ? 1.0 - x : x;
  ShapeValue value;
  if (y < share) {
    const double jerk = peak / share;
    const double slope = jerk * y;
    value = {
        .integral = slope * y * y / 6.0, .phi = 0.5 * slope * y, .slope = slope, .curvature = jerk};
  } else {
    value = {.integral = peak * (share * share / 6.0 + 0.5 * y * (y - share)),
             .phi = peak * (y - 0.5 * share),
             .slope = peak,
             .curvature = 0.0};
  }
  return second_half ? mirrored(x, value) : value;
}

}  // namespace kerf::profiles
