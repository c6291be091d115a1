// The plateau between two S-curves of given total length.
#pragma once

#include "profiles/transition.hpp"

namespace kerf::profiles {

// A search for the plateau: its rise above the faster end is in [0, largest_rise_mm_s].
struct PlateauSearch {
  Ramp ends{};
  double length_mm = 0.0;
  double largest_rise_mm_s = 0.0;  // finite; the two S-curves to it do not fit
};

// The rise of the plateau for which the two S-curves take the whole length, to some units in the
// last place; rounded to either side. 0 where even the direct transition does not fit. Jerk is
// limited.
double s_curve_plateau_rise(const PlateauSearch& search, const RampLimits& limits) noexcept;

}  // namespace kerf::profiles
