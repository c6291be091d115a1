#include "profiles/reach.hpp"

#include <algorithm>
#include <cmath>
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

// T = sqrt(dv / jerk): with w = sqrt(dv), f(w) = w^3 + 2 v w - 2 L sqrt(jerk) = 0. f is convex and
// rising for w > 0, and each term alone bounds w from above, so Newton's method from the smaller
// bound falls monotonically; at its worst (both terms equal) it needs five steps.
double change_by_jerk(const Approach& approach, double jerk_mm_s3) noexcept {
  if (std::isinf(jerk_mm_s3)) {
    return kInfinity;
  }
  const double target = 2.0 * approach.length_mm * std::sqrt(jerk_mm_s3);
  const double linear = 2.0 * approach.v_mm_s;
  double w = std::cbrt(target);
  if (linear * w > target) {
    w = target / linear;
  }
  constexpr int kMostSteps = 8;
  for (int step = 0; step < kMostSteps && w > 0.0; ++step) {
    const double next = (2.0 * w * w * w + target) / (3.0 * w * w + linear);
    const bool settled = next >= w * (1.0 - 1e-15);
    w = next;
    if (settled) {
      break;
    }
  }
  return w * w;
}

}  // namespace

double duration_s(double change_mm_s, const Peaks& peaks, const RampLimits& limits) noexcept {
  const double change = std::abs(change_mm_s);
  return std::max(peaks.acceleration * change / limits.acceleration_mm_s2,
                  std::sqrt(peaks.jerk * change / limits.jerk_mm_s3));
}

double s_curve_duration_s(double change_mm_s, const RampLimits& limits) noexcept {
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

double reachable_change(const Approach& approach, const Peaks& peaks,
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
