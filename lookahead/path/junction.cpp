#include "lookahead/path/junction.hpp"

#include <algorithm>
#include <cmath>

#include "profiles/profile.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kConstantVelocityTicks = 3.0;  // the support of a third difference
// Below these a junction is as smooth as positions in double precision can tell.
constexpr double kSmoothTangent = 1e-12;
constexpr double kSmoothCurvature_per_mm = 1e-12;
// Of the limits: what takes less is rounding, also where ten of them are seen together (a tick may
// be a millionth above its limits).
constexpr double kHardlySeen = 1e-7;
// Two parts at constant velocity at most fill a block; that much less, and sums of their lengths
// fit after rounding too.
constexpr double kBelowRounding = 1.0 - 1e-9;

struct Cubic {
  double linear = 0.0;
  double quadratic = 0.0;
  double cubic = 0.0;
};

// The largest F with linear F + quadratic F^2 + cubic F^3 <= bound; all terms >= 0. Newton from
// above on a convex, rising function descends to the root without passing it; rounding is taken off
// at the end.
double largest_below(const Cubic& f, double bound) {
  if (f.quadratic == 0.0 && f.cubic == 0.0) {
    return f.linear > 0.0 ? bound / f.linear : kUnbounded;  // between lines: always
  }
  if (!std::isfinite(bound)) {
    return kUnbounded;
  }
  double x = kUnbounded;
  if (f.linear > 0.0) {
    x = std::min(x, bound / f.linear);
  }
  if (f.quadratic > 0.0) {
    x = std::min(x, std::sqrt(bound / f.quadratic));
  }
  if (f.cubic > 0.0) {
    x = std::min(x, std::cbrt(bound / f.cubic));
  }
  if (!std::isfinite(x)) {
    return x;
  }
  for (int i = 0; i < 8; ++i) {
    const double value = x * (f.linear + x * (f.quadratic + x * f.cubic)) - bound;
    const double slope = f.linear + x * (2.0 * f.quadratic + x * 3.0 * f.cubic);
    x -= value / slope;
  }
  return x * (1.0 - 1e-12);
}

double limit_or_path(double axis, double path) {
  return std::isfinite(axis) ? axis : path;
}

// About what passing at a feedrate saves against a stop: half of braking to rest and half of
// accelerating from it, by the fastest law there is. It costs the two parts at constant velocity.
double saved_s(double feedrate_mm_s, const Block& before, const Block& after) {
  static const profiles::Profile kFastest(profiles::ProfileKind::s_curve);
  const profiles::RampLimits& a = before.limits.ramp;
  const profiles::RampLimits& b = after.limits.ramp;
  return kFastest.duration_s(
      feedrate_mm_s, {.acceleration_mm_s2 = std::min(a.acceleration_mm_s2, b.acceleration_mm_s2),
                      .jerk_mm_s3 = std::min(a.jerk_mm_s3, b.jerk_mm_s3)});
}

// About what the shorter block takes from rest to rest, by a lower bound: its jerk alone.
double stopping_s(const Block& before, const Block& after) {
  const double length_mm = std::min(before.length_mm, after.length_mm);
  const double jerk = std::min(before.limits.ramp.jerk_mm_s3, after.limits.ramp.jerk_mm_s3);
  return std::cbrt(32.0 * length_mm / jerk);
}

// Nothing is lost by a stop: neither the time of braking and accelerating nor that on the way.
bool is_better_stopped(double feedrate_mm_s, const Block& before, const Block& after,
                       double constant_velocity_s) {
  const double passing_s = std::min(before.length_mm, after.length_mm) / feedrate_mm_s;
  return saved_s(feedrate_mm_s, before, after) < 2.0 * constant_velocity_s &&
         stopping_s(before, after) < passing_s;
}

// The jump has no share in the limits of any axis at this feedrate.
bool is_hardly_seen(const BlockEnd& before, const BlockEnd& after, double feedrate_mm_s,
                    const PlanLimits& limits) {
  const double v = feedrate_mm_s;
  const double ts = limits.period_s;
  const auto is_little = [&](double turn, double bend, const MotionLimits& axis) {
    const MotionLimits& path = limits.path;
    const double jerk = limit_or_path(axis.jerk_mm_s3, path.jerk_mm_s3);
    const double acceleration = limit_or_path(axis.acceleration_mm_s2, path.acceleration_mm_s2);
    return v * turn / ts <= kHardlySeen * acceleration &&
           v * turn / (ts * ts) + 0.75 * v * v * bend / ts <= kHardlySeen * jerk;
  };
  bool all = is_little(path_step_of(before, after), 0.0, limits.path);
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    all = all &&
          is_little(std::abs(after.first[k] - before.first[k]),
                    std::abs(after.second_per_mm[k] - before.second_per_mm[k]), limits.axes[k]);
  }
  for (std::size_t k = 0; k < limits.extra.size(); ++k) {
    all = all &&
          is_little(std::abs(after.extra_per_mm[k] - before.extra_per_mm[k]), 0.0, limits.extra[k]);
  }
  return all;
}

}  // namespace

// How far a tick of length h that sees the junction may leave its chord, at the most: h |du| / 4 by
// the corner in its middle and h^2 max|k| / 8 by the curvature of both sides.
double chord_feedrate_mm_s(const BlockEnd& before, const BlockEnd& after,
                           const PlanLimits& limits) {
  const double ts = limits.period_s;
  const double turn = (curves::vec(after.first) - curves::vec(before.first)).norm();
  const double curvature = std::sqrt(std::max(curves::vec(before.second_per_mm).squaredNorm(),
                                              curves::vec(after.second_per_mm).squaredNorm()));
  return largest_below({.linear = 0.25 * turn * ts, .quadratic = 0.125 * curvature * ts * ts},
                       limits.chord_tolerance_mm);
}

double sub_tick_feedrate_mm_s(const Block& block, const PlanLimits& limits) {
  if (block.limit_curve.empty() || !std::isfinite(limits.chord_tolerance_mm)) {
    return kUnbounded;
  }
  return std::max(block.length_mm / limits.period_s,
                  chord_feedrate_mm_s(block.begin, block.end, limits));
}

double path_step_of(const BlockEnd& before, const BlockEnd& after) {
  return std::abs(curves::vec(after.first).norm() - curves::vec(before.first).norm());
}

double corner_feedrate_mm_s(const BlockEnd& before, const BlockEnd& after,
                            const PlanLimits& limits) {
  const double ts = limits.period_s;
  const double third = std::max(before.max_third_per_mm2, after.max_third_per_mm2);
  double feedrate = kUnbounded;
  for (std::size_t k = 0; k < 3; ++k) {
    const MotionLimits& axis = limits.axes[k];
    const double turn = std::abs(after.first[k] - before.first[k]);
    const double bend = std::abs(after.second_per_mm[k] - before.second_per_mm[k]);
    if (turn <= kSmoothTangent && bend <= kSmoothCurvature_per_mm) {
      continue;
    }
    const double curvature =
        std::max(std::abs(before.second_per_mm[k]), std::abs(after.second_per_mm[k]));
    const Cubic acceleration{.linear = turn / ts, .quadratic = curvature};
    const Cubic jerk{.linear = turn / (ts * ts), .quadratic = 0.75 * bend / ts, .cubic = third};
    feedrate =
        std::min({feedrate,
                  largest_below(acceleration, limit_or_path(axis.acceleration_mm_s2,
                                                            limits.path.acceleration_mm_s2)),
                  largest_below(jerk, limit_or_path(axis.jerk_mm_s3, limits.path.jerk_mm_s3))});
  }
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    const double turn = std::abs(after.extra_per_mm[k] - before.extra_per_mm[k]);
    if (turn > kSmoothTangent) {
      const MotionLimits& axis = limits.extra[k];
      feedrate = std::min(
          {feedrate, axis.acceleration_mm_s2 * ts / turn, axis.jerk_mm_s3 * ts * ts / turn});
    }
  }
  const double path_step = path_step_of(before, after);
  if (path_step > kSmoothTangent) {
    feedrate = std::min({feedrate, limits.path.acceleration_mm_s2 * ts / path_step,
                         limits.path.jerk_mm_s3 * ts * ts / path_step});
  }
  if (feedrate == kUnbounded || limits.chord_tolerance_mm == kUnbounded) {
    return feedrate;
  }
  return std::min(feedrate, chord_feedrate_mm_s(before, after, limits));
}

Junction junction_of(const JunctionQuery& query, const PlanLimits& limits) {
  const Block& before = *query.before;
  const Block& after = *query.after;
  const double cap = std::min(before.limits.feedrate_mm_s, after.limits.feedrate_mm_s);
  if (before.stop_after) {
    return {.feedrate_mm_s = 0.0};
  }
  if (after.continues) {
    return {.feedrate_mm_s = cap};
  }
  const double corner = corner_feedrate_mm_s(before.end, after.begin, limits);
  if (corner == kUnbounded || is_hardly_seen(before.end, after.begin, cap, limits)) {
    return {.feedrate_mm_s = cap};
  }
  const double constant_velocity = kConstantVelocityTicks * limits.period_s;
  const double fits =
      kBelowRounding * std::min(before.length_mm, after.length_mm) / (2.0 * constant_velocity);
  const double feedrate = std::min({cap, corner, fits});
  if (is_better_stopped(feedrate, before, after, constant_velocity)) {
    return {.feedrate_mm_s = 0.0};
  }
  return {.feedrate_mm_s = feedrate, .constant_velocity_s = constant_velocity};
}

}  // namespace kerf::lookahead
