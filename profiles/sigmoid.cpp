#include "profiles/sigmoid.hpp"

#include <algorithm>
#include <cmath>

#include "profiles/balance.hpp"

namespace kerf::profiles {
namespace {

struct Family {
  static constexpr double kJerkBest = Sigmoid::kJerkBestShape;
  static constexpr double kAccelerationBest = Sigmoid::kAccelerationBestShape;
  static ShapePeaks peaks(double shape) noexcept { return Sigmoid{shape}.peaks(); }
};

}  // namespace

Sigmoid::Sigmoid(double shape) noexcept
    : shape_(std::clamp(shape, kSmallestShape, kLargestShape)),
      gain_(0.5 / std::tanh(0.5 * shape_)),
      joint_tanh_(std::tanh(shape_ / 6.0)) {}

Sigmoid Sigmoid::fastest(double change_mm_s, const RampLimits& limits) {
  return Sigmoid{balanced_parameter<Family>(change_mm_s, limits)};
}

double Sigmoid::duration_s(double change_mm_s, const RampLimits& limits) {
  return profiles::duration_s(change_mm_s, fastest(change_mm_s, limits).peaks(), limits);
}

double Sigmoid::reachable_change(const Approach& approach, const RampLimits& limits) {
  return balanced_reachable_change<Family>(approach, limits);
}

Sigmoid::Cubic Sigmoid::cubic() const noexcept {
  const double phi = 0.5 - gain_ * joint_tanh_;
  const double slope = shape_ * gain_ * (1.0 - joint_tanh_ * joint_tanh_);
  return {.b1 = 9.0 * slope - 54.0 * phi, .b2 = 27.0 * phi - 3.0 * slope};
}

ShapePeaks Sigmoid::peaks() const noexcept {
  const auto [b1, b2] = cubic();
  ShapePeaks peaks{.acceleration = shape_ * gain_,
                   .jerk = std::max(std::abs(2.0 * b2), std::abs(2.0 * b1 + 2.0 * b2))};
  if (b1 < 0.0 && b2 < -b1) {  // the cubic's own peak, at x = -b2 / (3 b1) < 1/3
    peaks.acceleration = std::max(peaks.acceleration, -b2 * b2 / (3.0 * b1));
  }
  // |tanh''| = 2 t (1 - t^2) grows up to t^2 = 1/3, which the joint may or may not reach.
  constexpr double kExtreme = 0.57735026918962576;
  const double t = std::min(joint_tanh_, kExtreme);
  peaks.jerk = std::max(peaks.jerk, 2.0 * shape_ * shape_ * gain_ * t * (1.0 - t * t));
  return peaks;
}

ShapeValue Sigmoid::at(double x) const noexcept {
  constexpr double kThird = 1.0 / 3.0;
  const auto [b1, b2] = cubic();
  const bool second_half = x > 0.5;
  const double y = second_half ? 1.0 - x : x;
  ShapeValue value;
  if (y < kThird) {
    value = {.integral = y * y * y * (0.25 * b1 * y + b2 / 3.0),
             .phi = y * y * (b1 * y + b2),
             .slope = y * (3.0 * b1 * y + 2.0 * b2),
             .curvature = 6.0 * b1 * y + 2.0 * b2};
  } else {
    const double t = std::tanh(shape_ * (y - 0.5));
    const double rest = 1.0 - t * t;
    // The antiderivative of tanh is log cosh = -log(1 - tanh^2) / 2; here from the joint to y.
    const double log_cosh_change = 0.5 * std::log1p((t * t - joint_tanh_ * joint_tanh_) / rest);
    value = {
        .integral = b1 / 324.0 + b2 / 81.0 + 0.5 * (y - kThird) + gain_ / shape_ * log_cosh_change,
        .phi = 0.5 + gain_ * t,
        .slope = shape_ * gain_ * rest,
        .curvature = -2.0 * shape_ * shape_ * gain_ * t * rest};
  }
  return second_half ? mirrored(x, value) : value;
}

}  // namespace kerf::profiles
