#include "profiles/profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "profiles/balance.hpp"
#include "profiles/plateau.hpp"

namespace kerf::profiles {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Peaks kTrapezoidPeaks{.acceleration = 1.0, .jerk = 0.0};

constexpr std::array<std::string_view, 6> kNames{"trapezoid", "s-curve",     "sine",
                                                 "quintic",   "sine-series", "sigmoid"};

// The largest value in [floor, candidate], or a few units in the last place below it, for which
// `fits` holds; it holds for floor, and the candidate misses by rounding at most.
template <class Fits>
double rounded_down(double candidate, double floor, Fits fits) {
  double step = candidate * std::numeric_limits<double>::epsilon();
  constexpr int kMostSteps = 60;
  for (int i = 0; i < kMostSteps && candidate > floor; ++i) {
    if (fits(candidate)) {
      return candidate;
    }
    candidate -= step;
    step *= 2.0;
  }
  return floor;
}

}  // namespace

std::string_view name_of(ProfileKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<ProfileKind> profile_kind(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) {
    return std::nullopt;
  }
  return static_cast<ProfileKind>(found - kNames.begin());
}

Profile::Profile(ProfileKind kind, std::optional<double> sigmoid_shape)
    : kind_(kind), sigmoid_shape_(sigmoid_shape) {}

double Profile::duration_s(double change_mm_s, const RampLimits& limits) const {
  switch (kind_) {
    case ProfileKind::trapezoid:
      return profiles::duration_s(change_mm_s, kTrapezoidPeaks, limits);
    case ProfileKind::s_curve:
      return s_curve_duration_s(change_mm_s, limits);
    case ProfileKind::sine:
      return profiles::duration_s(change_mm_s, Sine::kPeaks, limits);
    case ProfileKind::quintic:
      return profiles::duration_s(change_mm_s, Quintic::kPeaks, limits);
    case ProfileKind::sine_series:
      return SineSeries::duration_s(change_mm_s, limits);
    case ProfileKind::sigmoid:
      break;
  }
  return sigmoid_shape_
             ? profiles::duration_s(change_mm_s, Sigmoid{*sigmoid_shape_}.peaks(), limits)
             : Sigmoid::duration_s(change_mm_s, limits);
}

double Profile::length_mm(const Ramp& ramp, const RampLimits& limits) const {
  return 0.5 * (ramp.v_begin_mm_s + ramp.v_end_mm_s) *
         duration_s(ramp.v_end_mm_s - ramp.v_begin_mm_s, limits);
}

Transition Profile::fastest(const Ramp& ramp, const RampLimits& limits) const {
  const double change = ramp.v_end_mm_s - ramp.v_begin_mm_s;
  const auto shape = [&]() -> Shape {
    switch (kind_) {
      case ProfileKind::trapezoid:
        return Trapezoid::fastest(change, limits);
      case ProfileKind::s_curve:
        return SCurve::fastest(change, limits);
      case ProfileKind::sine:
        return Sine::fastest(change, limits);
      case ProfileKind::quintic:
        return Quintic::fastest(change, limits);
      case ProfileKind::sine_series:
        return SineSeries::fastest(change, limits);
      case ProfileKind::sigmoid:
        break;
    }
    return sigmoid_shape_ ? Sigmoid{*sigmoid_shape_} : Sigmoid::fastest(change, limits);
  };
  return {ramp, duration_s(change, limits), shape()};
}

double Profile::reach_mm_s(const Approach& approach, const RampLimits& limits) const {
  const auto change = [&] {
    switch (kind_) {
      case ProfileKind::trapezoid:
        return reachable_change(approach, kTrapezoidPeaks, limits);
      case ProfileKind::s_curve:
        return s_curve_reachable_change(approach, limits);
      case ProfileKind::sine:
        return reachable_change(approach, Sine::kPeaks, limits);
      case ProfileKind::quintic:
        return reachable_change(approach, Quintic::kPeaks, limits);
      case ProfileKind::sine_series:
        return SineSeries::reachable_change(approach, limits);
      case ProfileKind::sigmoid:
        break;
    }
    return sigmoid_shape_ ? reachable_change(approach, Sigmoid{*sigmoid_shape_}.peaks(), limits)
                          : Sigmoid::reachable_change(approach, limits);
  }();
  if (std::isinf(change)) {
    return kInfinity;
  }
  return rounded_down(approach.v_mm_s + change, approach.v_mm_s, [&](double v_mm_s) {
    return length_mm({.v_begin_mm_s = approach.v_mm_s, .v_end_mm_s = v_mm_s}, limits) <=
           approach.length_mm;
  });
}

// A feedrate not below the peak, and not below either end. Each end reaches no further than with
// the length that is left when the other leg takes its least, and one leg has no more than half.
double Profile::peak_bound(const Ramp& ends, double length_mm, const RampLimits& limits) const {
  const auto [slower, faster] = std::minmax(ends.v_begin_mm_s, ends.v_end_mm_s);
  const double direct_mm = this->length_mm(ends, limits);
  const double left_mm = std::max(0.0, length_mm - direct_mm);
  const double from_faster = reach_mm_s({.v_mm_s = faster, .length_mm = left_mm}, limits);
  const double from_half =
      std::max(reach_mm_s({.v_mm_s = faster, .length_mm = 0.5 * length_mm}, limits),
               reach_mm_s({.v_mm_s = slower, .length_mm = 0.5 * length_mm}, limits));
  // Both are rounded down, which a bound must not be.
  return std::min(from_faster, from_half) * (1.0 + 1e-14);
}

double Profile::peak_mm_s(const Ramp& ends, const Room& room, const RampLimits& limits) const {
  const auto [slower, faster] = std::minmax(ends.v_begin_mm_s, ends.v_end_mm_s);
  const auto length_at = [&](double v_mm_s) {
    return length_mm({.v_begin_mm_s = ends.v_begin_mm_s, .v_end_mm_s = v_mm_s}, limits) +
           length_mm({.v_begin_mm_s = v_mm_s, .v_end_mm_s = ends.v_end_mm_s}, limits);
  };
  const auto fits = [&](double v_mm_s) { return length_at(v_mm_s) <= room.length_mm; };
  if (!(room.v_cap_mm_s > faster)) {
    return faster;
  }
  if (std::isfinite(room.v_cap_mm_s) && fits(room.v_cap_mm_s)) {
    return room.v_cap_mm_s;
  }
  double peak = 0.0;
  if (slower == faster) {
    peak = reach_mm_s({.v_mm_s = faster, .length_mm = 0.5 * room.length_mm}, limits);
  } else {
    peak = peak_bound(ends, room.length_mm, limits);
    const double rise = std::min(peak, room.v_cap_mm_s) - faster;
    if (std::isinf(rise) || !(rise > 0.0)) {
      peak = faster + std::max(0.0, rise);
    } else if (kind_ == ProfileKind::s_curve && std::isfinite(limits.jerk_mm_s3)) {
      peak = faster +
             s_curve_plateau_rise(
                 {.ends = ends, .length_mm = room.length_mm, .largest_rise_mm_s = rise}, limits);
    } else {
      // By the square root of the rise, in which the length is smooth at 0.
      const double root =
          bracketed_root({.positive = std::sqrt(rise), .other = 0.0},
                         [&](double w) { return length_at(faster + w * w) - room.length_mm; });
      peak = faster + root * root;
    }
  }
  peak = std::min(peak, room.v_cap_mm_s);
  return std::isinf(peak) ? peak : rounded_down(peak, faster, fits);
}

}  // namespace kerf::profiles
