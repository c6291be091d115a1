#include "profiles/s_curve_stop.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::profiles {

namespace {

// What follows rounds.
constexpr double kInside = 1.0 - 1e-9;
constexpr double kRounding = 1e-12;

}  // namespace

std::optional<SCurveStop> s_curve_stop(const PathMotion& from, const RampLimits& limits) noexcept {
  const double v = from.v_mm_s;
  const double a = from.a_mm_s2;
  const double most = limits.acceleration_mm_s2 * kInside;
  const double jerk = limits.jerk_mm_s3 * kInside;
  if (!(std::isfinite(most) && std::isfinite(jerk)) || std::abs(a) > limits.acceleration_mm_s2) {
    return std::nullopt;
  }
  const double low = std::max(std::min(std::sqrt(jerk * v + 0.5 * a * a), most), -a);
  const double fall_s = (low + a) / jerk;
  const double land_s = low / jerk;
  const double v_landing = 0.5 * low * land_s;
  SCurveStop stop;
  double v_steady = v;
  if (fall_s > 0.0) {
    stop.falling = CellLaw::ramp({.v_mm_s = v, .a_mm_s2 = a, .j_mm_s3 = -jerk}, fall_s);
    v_steady = stop.falling.v_end_mm_s();
  }
  const double steady_s = (v_steady - v_landing) / low;
  if (steady_s * low < -kRounding * std::max(v, a * a / jerk)) {  // the highest to come, about
    return std::nullopt;
  }
  if (steady_s > 0.0) {
    stop.steady = CellLaw::ramp({.v_mm_s = v_steady, .a_mm_s2 = -low}, steady_s);
  }
  stop.landing = CellLaw::landing(v_landing, v_landing * land_s / 3.0);
  return stop;
}

}  // namespace kerf::profiles
