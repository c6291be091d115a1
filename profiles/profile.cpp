#include "profiles/profile.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "profiles/balance.hpp"
#include "profiles/cruise_rise.hpp"

namespace kerf::profiles {
namespace {

constexpr ShapePeaks kTrapezoidPeaks{.acceleration = 1.0, .jerk = 0.0};

// The largest value in [floor, candidate], or a few units in the last place below it, for which
// `fits` holds; it holds for floor, and the candidate misses by rounding at most.
template <class Fits>
double rounded_down(double candidate, double floor, Fits fits) {
  double step = candidate * std::numeric_limits<double>::epsilon();
  constexpr int kMaxSteps = 60;
  for (int i = 0; i < kMaxSteps && candidate > floor; ++i) {
    if (fits(candidate)) {
      return candidate;
    }
    candidate -= step;
    step *= 2.0;
  }
  return floor;
}

bool knows_no_jerk(ProfileKind kind, const RampLimits& limits) {
  return kind == ProfileKind::trapezoid || std::isinf(limits.jerk_mm_s3);
}

}  // namespace

Profile::Profile(ProfileKind kind, std::optional<double> sigmoid_shape)
    : kind_(kind), sigmoid_shape_(sigmoid_shape) {}

double Profile::duration_s(double change_mm_s, const RampLimits& limits) const {
  switch (kind_) {
    case ProfileKind::trapezoid:
      return profiles::duration_s(change_mm_s, kTrapezoidPeaks, limits);
    case ProfileKind::s_curve:
    case ProfileKind::time_optimal:
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
      case ProfileKind::time_optimal:
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

double Profile::length_over_mm(const Ramp& ends, double cruise_mm_s,
                               const RampLimits& limits) const {
  return length_mm({.v_begin_mm_s = ends.v_begin_mm_s, .v_end_mm_s = cruise_mm_s}, limits) +
         length_mm({.v_begin_mm_s = cruise_mm_s, .v_end_mm_s = ends.v_end_mm_s}, limits);
}

double Profile::reachable_change(const Approach& approach, const RampLimits& limits) const {
  switch (kind_) {
    case ProfileKind::trapezoid:
      return profiles::reachable_change(approach, kTrapezoidPeaks, limits);
    case ProfileKind::s_curve:
    case ProfileKind::time_optimal:
      return s_curve_reachable_change(approach, limits);
    case ProfileKind::sine:
      return profiles::reachable_change(approach, Sine::kPeaks, limits);
    case ProfileKind::quintic:
      return profiles::reachable_change(approach, Quintic::kPeaks, limits);
    case ProfileKind::sine_series:
      return SineSeries::reachable_change(approach, limits);
    case ProfileKind::sigmoid:
      break;
  }
  return sigmoid_shape_
             ? profiles::reachable_change(approach, Sigmoid{*sigmoid_shape_}.peaks(), limits)
             : Sigmoid::reachable_change(approach, limits);
}

double Profile::reach_mm_s(const Approach& approach, const RampLimits& limits) const {
  assert(approach.v_mm_s >= 0.0 && approach.length_mm >= 0.0);
  assert(approach.v_cap_mm_s >= approach.v_mm_s);
  const auto fits = [&](double v_mm_s) {
    return length_mm({.v_begin_mm_s = approach.v_mm_s, .v_end_mm_s = v_mm_s}, limits) <=
           approach.length_mm;
  };
  const double cap = approach.v_cap_mm_s;
  if (std::isfinite(cap) && fits(cap)) {
    return cap;
  }
  const double reach = std::min(cap, approach.v_mm_s + reachable_change(approach, limits));
  return std::isinf(reach) ? reach : rounded_down(reach, approach.v_mm_s, fits);
}

// The leg from the slower end takes at least the direct transition to the faster end, so the faster
// end reaches no higher than with what that leaves: the bound that the searches start from.
double Profile::cruise_rise(const Ramp& ends, const Room& room, const RampLimits& limits) const {
  const double faster = std::max(ends.v_begin_mm_s, ends.v_end_mm_s);
  const double left_mm = std::max(0.0, room.length_mm - length_mm(ends, limits));
  if (ends.v_begin_mm_s == ends.v_end_mm_s || knows_no_jerk(kind_, limits)) {
    // Both legs beyond the direct transition are equal; without jerk, v^2 grows with the length.
    return reachable_change({.v_mm_s = faster, .length_mm = 0.5 * left_mm}, limits);
  }
  const double rise = std::min(room.v_cap_mm_s - faster,
                               reachable_change({.v_mm_s = faster, .length_mm = left_mm}, limits));
  if (std::isinf(rise)) {
    return rise;
  }
  if (kind_ == ProfileKind::s_curve) {
    return s_curve_cruise_rise(
        {.ends = ends, .length_mm = room.length_mm, .largest_rise_mm_s = rise}, limits);
  }
  // By the square root of the rise, in which the length is smooth at 0.
  const double root = bracketed_root({.positive = std::sqrt(rise), .other = 0.0}, [&](double w) {
    return length_over_mm(ends, faster + w * w, limits) - room.length_mm;
  });
  return root * root;
}

double Profile::peak_mm_s(const Ramp& ends, const Room& room, const RampLimits& limits) const {
  assert(ends.v_begin_mm_s >= 0.0 && ends.v_end_mm_s >= 0.0 && room.length_mm >= 0.0);
  const double faster = std::max(ends.v_begin_mm_s, ends.v_end_mm_s);
  const auto fits = [&](double v_mm_s) {
    return length_over_mm(ends, v_mm_s, limits) <= room.length_mm;
  };
  if (!(room.v_cap_mm_s > faster)) {
    return faster;
  }
  if (std::isfinite(room.v_cap_mm_s) && fits(room.v_cap_mm_s)) {
    return room.v_cap_mm_s;
  }
  const double peak = std::min(faster + cruise_rise(ends, room, limits), room.v_cap_mm_s);
  return std::isinf(peak) ? peak : rounded_down(peak, faster, fits);
}

}  // namespace kerf::profiles
