// Durations, and the largest change of feedrate that fits into a length, in closed form.
//
// A transition by dv from v takes the length (v + dv/2) T(dv) (docs/math.md, 2.9), so each law's
// duration T gives an equation for dv: a quadratic where acceleration binds, a cubic in sqrt(dv)
// with one real root where jerk does. The duration of every law grows with the change, so where it
// is the larger of two, the change that fits is the smaller of two.
#pragma once

#include <limits>

#include "profiles/feedrate_shape.hpp"

namespace kerf::profiles {

// Where a transition starts and how long it may be.
struct Approach {
  double v_mm_s = 0.0;     // >= 0
  double length_mm = 0.0;  // >= 0
  // Feedrates above are of no interest; most questions are answered by trying it. >= v_mm_s.
  double v_cap_mm_s = std::numeric_limits<double>::infinity();
};

// T = max(a* |dv| / A, sqrt(j* |dv| / J)). 0 where no limit binds.
double duration_s(double change_mm_s, const ShapePeaks& peaks, const RampLimits& limits) noexcept;
// T = |dv| / A + A / J where |dv| >= A^2 / J, else 2 sqrt(|dv| / J).
double s_curve_duration_s(double change_mm_s, const RampLimits& limits) noexcept;

// The cap aside, the largest change dv >= 0 [mm/s] whose transition from approach.v_mm_s upwards
// fits, to some units in the last place; rounded to either side. Infinite where no limit binds.
double reachable_change(const Approach& approach, const ShapePeaks& peaks,
                        const RampLimits& limits) noexcept;
double s_curve_reachable_change(const Approach& approach, const RampLimits& limits) noexcept;

}  // namespace kerf::profiles
