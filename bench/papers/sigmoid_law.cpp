#include "bench/papers/sigmoid_law.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kerf::bench {

profiles::ShapePeaks peaks_of(const profiles::Profile& profile) {
  constexpr profiles::RampLimits kByAcceleration{.acceleration_mm_s2 = 1.0, .jerk_mm_s3 = 1e12};
  constexpr profiles::RampLimits kByJerk{.acceleration_mm_s2 = 1e12, .jerk_mm_s3 = 1.0};
  const double by_jerk_s = profile.duration_s(1.0, kByJerk);
  return {.acceleration = profile.duration_s(1.0, kByAcceleration), .jerk = by_jerk_s * by_jerk_s};
}

double paper_bound_of_jerk(double shape) {
  const auto f = [](double x) { return 1.0 / (1.0 + std::exp(-x)); };
  const double span = f(shape) - f(-shape);
  const double q = f(-shape / 3.0) - f(-shape);
  const double p = f(-shape / 3.0) * (1.0 - f(-shape / 3.0));
  const double of_logistic = shape * shape * std::numbers::sqrt3 / 18.0 / span;
  const double at_begin = std::abs(54.0 * q - 12.0 * shape * p) / (4.0 * span);
  const double at_joint = std::abs(24.0 * shape * p - 54.0 * q) / (4.0 * span);
  return std::max({of_logistic, at_begin, at_joint});
}

}  // namespace kerf::bench
