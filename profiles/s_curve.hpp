// S-curve: trapezoidal acceleration, the fastest transition there is under limits on both.
#pragma once

#include "profiles/feedrate_shape.hpp"

namespace kerf::profiles {

// Constant jerk during the first and the last `jerk_share` of the duration, constant acceleration
// between. 1/2 is the triangular acceleration; 0 is the trapezoid (unbounded jerk).
class SCurve {
 public:
  SCurve() = default;
  // jerk_share in [0, 1/2]; clamped.
  explicit SCurve(double jerk_share) noexcept;
  static SCurve fastest(double change_mm_s, const RampLimits& limits) noexcept;

  [[nodiscard]] double jerk_share() const noexcept { return jerk_share_; }
  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept { return 1.0 / (1.0 - jerk_share_); }
  [[nodiscard]] double peak_jerk() const noexcept {
    return 1.0 / (jerk_share_ * (1.0 - jerk_share_));
  }

 private:
  double jerk_share_ = 0.5;
};

static_assert(FeedrateShape<SCurve>);

}  // namespace kerf::profiles
