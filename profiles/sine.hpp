// Sine: acceleration is half a sine wave [LeeEtAl], the baseline of the papers.
#pragma once

#include "profiles/feedrate_shape.hpp"

namespace kerf::profiles {

// phi = (1 + sin(pi (x - 1/2))) / 2 (docs/math.md, 2.4). Jerk jumps at both ends.
class Sine {
 public:
  static constexpr ShapePeaks kPeaks{.acceleration = 1.5707963267948966,  // pi / 2
                                     .jerk = 4.934802200544679};          // pi^2 / 2

  static Sine fastest(double change_mm_s, const RampLimits& limits) noexcept;

  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept { return kPeaks.acceleration; }
  [[nodiscard]] double peak_jerk() const noexcept { return kPeaks.jerk; }
};

static_assert(FeedrateShape<Sine>);

}  // namespace kerf::profiles
