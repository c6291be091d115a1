// The law of [Quintic]: the polynomial of lowest degree whose acceleration and jerk are 0 at both
// ends.
#pragma once

#include "profiles/feedrate_shape.hpp"

namespace kerf::profiles {

// phi = 10 x^3 - 15 x^4 + 6 x^5 (docs/math.md, 2.5). Jerk is continuous and 0 at both ends.
class Quintic {
 public:
  static constexpr ShapePeaks kPeaks{
      .acceleration = 1.875,       // at x = 1/2
      .jerk = 5.773502691896258};  // 10 / sqrt(3), at 0.211 and 0.789

  static Quintic fastest(double change_mm_s, const RampLimits& limits) noexcept;

  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept { return kPeaks.acceleration; }
  [[nodiscard]] double peak_jerk() const noexcept { return kPeaks.jerk; }
};

static_assert(FeedrateShape<Quintic>);

}  // namespace kerf::profiles
