// The cruise between two S-curves of given total length.
#pragma once

#include "profiles/transition.hpp"

namespace kerf::profiles {

// A search for the cruise: its rise above the faster end is in [0, largest_rise_mm_s].
struct CruiseRoom {
  Ramp ends{};
  double length_mm = 0.0;
  double largest_rise_mm_s = 0.0;  // finite; the two S-curves to it do not fit
};

// The rise of the cruise for which the two S-curves take the whole length, to some units in the
// last place; rounded to either side. 0 where even the direct transition does not fit. Jerk is
// limited.
double s_curve_cruise_rise(const CruiseRoom& search, const RampLimits& limits) noexcept;

}  // namespace kerf::profiles
