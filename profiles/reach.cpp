#include "profiles/reach.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

namespace kerf::profiles {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Solves dv^2 + 2 p dv = q for dv >= 0, without the cancellation of the schoolbook form.
double quadratic_root(double p, double q) noexcept {
  const double denominator = p + std::sqrt(p * p + q);
  return denominator > 0.0 ? q / denominator : 0.0;
}

// T = dv / acceleration: dv^2 + 2 v dv = 2 L acceleration.
double change_by_acceleration(const Approach& approach, double acceleration_mm_s2) noexcept {
  if (std::isinf(acceleration_mm_s2)) {
    return kInfinity;
  }
  return quadratic_root(approach.v_mm_s, 2.0 * approach.length_mm * acceleration_mm_s2);
}

// Within 4 % of the cube root of a positive normal number: a third of its bits is a third of its
// exponent, the constant restores the bias and centres the error.
double rough_cube_root(double value) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) / 3 + 0x2a9f8a7be393b600U);
}

// T = sqrt(dv / jerk): with w = sqrt(dv), f(w) = w^3 + 2 v w - 2 L sqrt(jerk) = 0. The planner asks
// this for every block, so no library cube root: a rational start within 10 % of the root for every
// ratio of the two terms (it is exact where one of them vanishes, but for the rough cube root),
// then three of Halley's cubically convergent steps, each of which has f, f' and f'' > 0.
double change_by_jerk(const Approach& approach, double jerk_mm_s3) noexcept {
  if (std::isinf(jerk_mm_s3)) {
    return kInfinity;
  }
  const double target = 2.0 * approach.length_mm * std::sqrt(jerk_mm_s3);
  if (!(target > std::numeric_limits<double>::min())) {
    return 0.0;
  }
  const double linear = 2.0 * approach.v_mm_s;
  const double c = rough_cube_root(target);
  const double c2 = c * c;
  double w = target * (c2 + 0.6 * linear) / (c2 * c2 + 0.77 * c2 * linear + 0.6 * linear * linear);
  for (int step = 0; step < 3; ++step) {
    const double f = w * (w * w + linear) - target;
    const double slope = 3.0 * w * w + linear;
    w -= f * slope / (slope * slope - 3.0 * w * f);
  }
  return w * w;
}

}  // namespace

double duration_s(double change_mm_s, const ShapePeaks& peaks, const RampLimits& limits) noexcept {
  assert(limits.acceleration_mm_s2 > 0.0 && limits.jerk_mm_s3 > 0.0);
  const double change = std::abs(change_mm_s);
  return std::max(peaks.acceleration * change / limits.acceleration_mm_s2,
                  std::sqrt(peaks.jerk * change / limits.jerk_mm_s3));
}

double s_curve_duration_s(double change_mm_s, const RampLimits& limits) noexcept {
  assert(limits.acceleration_mm_s2 > 0.0 && limits.jerk_mm_s3 > 0.0);
  const double change = std::abs(change_mm_s);
  if (std::isinf(limits.jerk_mm_s3)) {
    return change / limits.acceleration_mm_s2;
  }
  const double jerk_phase_s = limits.acceleration_mm_s2 / limits.jerk_mm_s3;
  if (change > limits.acceleration_mm_s2 * jerk_phase_s) {
    return change / limits.acceleration_mm_s2 + jerk_phase_s;
  }
  return 2.0 * std::sqrt(change / limits.jerk_mm_s3);
}

double reachable_change(const Approach& approach, const ShapePeaks& peaks,
                        const RampLimits& limits) noexcept {
  const double by_acceleration =
      change_by_acceleration(approach, limits.acceleration_mm_s2 / peaks.acceleration);
  if (!(peaks.jerk > 0.0)) {
    return by_acceleration;
  }
  return std::min(by_acceleration, change_by_jerk(approach, limits.jerk_mm_s3 / peaks.jerk));
}

double s_curve_reachable_change(const Approach& approach, const RampLimits& limits) noexcept {
  if (std::isinf(limits.jerk_mm_s3)) {
    return change_by_acceleration(approach, limits.acceleration_mm_s2);
  }
  const double jerk_phase_s = limits.acceleration_mm_s2 / limits.jerk_mm_s3;
  const double largest_triangular = limits.acceleration_mm_s2 * jerk_phase_s;
  const double triangular_length_mm = (2.0 * approach.v_mm_s + largest_triangular) * jerk_phase_s;
  if (!(approach.length_mm > triangular_length_mm)) {
    return change_by_jerk(approach, 0.25 * limits.jerk_mm_s3);
  }
  // (v + dv/2) (dv/A + A/J) = L
  return quadratic_root(
      approach.v_mm_s + 0.5 * largest_triangular,
      2.0 * limits.acceleration_mm_s2 * (approach.length_mm - approach.v_mm_s * jerk_phase_s));
}

}  // namespace kerf::profiles
