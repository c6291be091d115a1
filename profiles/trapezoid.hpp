// Trapezoidal velocity: constant acceleration, unbounded jerk.
#pragma once

#include "profiles/feedrate_shape.hpp"

namespace kerf::profiles {

// phi = x (docs/math.md, 2.2). It ignores the jerk limit.
class Trapezoid {
 public:
  static Trapezoid fastest(double change_mm_s, const RampLimits& limits) noexcept;

  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept { return 1.0; }
  [[nodiscard]] double peak_jerk() const noexcept;  // infinite
};

static_assert(FeedrateShape<Trapezoid>);

}  // namespace kerf::profiles
