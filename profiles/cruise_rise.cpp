// With w = sqrt(rise) both lengths are polynomials of w, or of sqrt(d + w^2) with d the difference
// of the ends, where jerk alone binds, and polynomials of w^2 where acceleration does too, joined
// with a continuous derivative. All of these are convex, so Newton's method from above falls
// monotonically to the root; in the rise itself the slope would be infinite at 0.
#include "profiles/cruise_rise.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace kerf::profiles {
namespace {

struct Growth {
  double length_mm = 0.0;
  double per_w = 0.0;  // d length / dw
};

// What the lengths of S-curves under the same limits have in common.
struct SCurveTimes {
  double acceleration_mm_s2;
  double jerk_phase_s;        // A / J
  double largest_triangular;  // A^2 / J [mm/s]
  double by_root_jerk;        // 1 / sqrt(J)
};

// What is left of the feedrates where the search stands at w.
struct Rise {
  double v_mm_s;
  double change_mm_s;  // constant + w^2
  double w;
};

// An S-curve from v to v + change.
Growth s_curve_growth(const Rise& rise, const SCurveTimes& times) {
  const auto [v_mm_s, change_mm_s, w] = rise;
  if (change_mm_s > times.largest_triangular) {
    const double mean = v_mm_s + 0.5 * change_mm_s;
    const double duration = change_mm_s / times.acceleration_mm_s2 + times.jerk_phase_s;
    return {.length_mm = mean * duration,
            .per_w = 2.0 * w * (0.5 * duration + mean / times.acceleration_mm_s2)};
  }
  const double root = std::sqrt(change_mm_s);
  const double w_by_root = root > 0.0 ? w / root : 1.0;  // both are 0 only where root is w
  return {.length_mm = (2.0 * v_mm_s + change_mm_s) * root * times.by_root_jerk,
          .per_w = w_by_root * (2.0 * v_mm_s + 3.0 * change_mm_s) * times.by_root_jerk};
}

}  // namespace

double s_curve_cruise_rise(const CruiseRoom& search, const RampLimits& limits) noexcept {
  assert(0.0 <= search.largest_rise_mm_s && std::isfinite(search.largest_rise_mm_s));
  assert(std::isfinite(limits.jerk_mm_s3));
  const double faster = std::max(search.ends.v_begin_mm_s, search.ends.v_end_mm_s);
  const double slower = std::min(search.ends.v_begin_mm_s, search.ends.v_end_mm_s);
  const double jerk_phase_s = limits.acceleration_mm_s2 / limits.jerk_mm_s3;
  const SCurveTimes times{.acceleration_mm_s2 = limits.acceleration_mm_s2,
                          .jerk_phase_s = jerk_phase_s,
                          .largest_triangular = limits.acceleration_mm_s2 * jerk_phase_s,
                          .by_root_jerk = 1.0 / std::sqrt(limits.jerk_mm_s3)};
  double w = std::sqrt(search.largest_rise_mm_s);
  constexpr int kMaxSteps = 40;
  for (int step = 0; step < kMaxSteps; ++step) {
    const Growth from_faster = s_curve_growth({faster, w * w, w}, times);
    const Growth from_slower = s_curve_growth({slower, faster - slower + w * w, w}, times);
    const double excess = from_faster.length_mm + from_slower.length_mm - search.length_mm;
    const double per_w = from_faster.per_w + from_slower.per_w;
    if (!(excess > 0.0) || !(per_w > 0.0)) {
      break;
    }
    const double next = w - excess / per_w;
    if (!(next > 0.0)) {
      return 0.0;
    }
    const bool settled = next >= w * (1.0 - 1e-15);
    w = next;
    if (settled) {
      break;
    }
  }
  return w * w;
}

}  // namespace kerf::profiles
