// Sine series with a geometric sequence of coefficients [SineSeries]: continuous jerk.
#pragma once

#include "profiles/feedrate_shape.hpp"
#include "profiles/reach.hpp"

namespace kerf::profiles {

// phi' = (1 + r) (1 - cos 2 pi x) / (1 - 2 r cos 2 pi x + r^2) with the ratio r in [0, 1)
// (docs/math.md, 2.7). A larger r has the lower peak acceleration; the lowest peak jerk is at
// r = sqrt(17) - 4. What is stored is the gap 1 - r, on which everything depends as r nears 1.
class SineSeries {
 public:
  // The ratio of the lowest j*; a smaller one is worse in both peaks.
  static constexpr double kGentlestRatio = 0.12310562561766059;
  // 1 - r of the largest ratio: a* is within 5e-10 of the trapezoid's there.
  static constexpr double kSmallestGap = 1e-9;

  SineSeries() noexcept : SineSeries(kGentlestRatio) {}
  // ratio in [0, 1 - kSmallestGap]; clamped.
  explicit SineSeries(double ratio) noexcept;

  // The optimal ratio for the transition: jerk binds throughout (kGentlestRatio), acceleration
  // binds throughout (1 - kSmallestGap), or both bind at once, which is where they cross.
  static SineSeries fastest(double change_mm_s, const RampLimits& limits);
  // The duration of that, and the change that reaches over a length (see profiles/reach.hpp).
  static double duration_s(double change_mm_s, const RampLimits& limits);
  static double reachable_change(const Approach& approach, const RampLimits& limits);

  [[nodiscard]] double ratio() const noexcept { return 1.0 - gap_; }
  [[nodiscard]] ShapeValue at(double x) const noexcept;
  [[nodiscard]] double peak_acceleration() const noexcept;
  [[nodiscard]] double peak_jerk() const noexcept;

 private:
  double gap_;               // 1 - r
  double dilogarithm_of_r_;  // Li2(r)
};

static_assert(FeedrateShape<SineSeries>);

}  // namespace kerf::profiles
