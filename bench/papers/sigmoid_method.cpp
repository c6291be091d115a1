#include "bench/papers/sigmoid_method.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "lookahead/classical/limit_curve_cuts.hpp"

namespace kerf::bench {

using lookahead::VelocityLimitCurve;
using profiles::Ramp;
using profiles::RampLimits;
using profiles::Transition;

namespace {

double error_mm(const ParametricCurve& curve, ChordRule rule, double u, double u_next) {
  if (rule == ChordRule::largest_distance) {
    return curve.chord_error_mm(u, u_next);
  }
  const ParametricPoint from = curve.at(u);
  const Eigen::Vector3d to = curve.position_mm(u_next);
  if (rule == ChordRule::at_middle_parameter) {
    return (curve.position_mm(0.5 * (u + u_next)) - 0.5 * (from.at_mm + to)).norm();
  }
  const double speed = from.first.norm();
  const double curvature = from.first.cross(from.second).norm() / (speed * speed * speed);
  const double half_mm = 0.5 * (to - from.at_mm).norm();
  const double bend = std::min(curvature * half_mm, 1.0);
  // 1 - sqrt(1 - x^2), without cancellation
  return curvature > 0.0 ? bend * bend / (1.0 + std::sqrt(1.0 - bend * bend)) / curvature : 0.0;
}

std::vector<MethodPlace> places_of(const VelocityLimitCurve& scan, bool dips) {
  constexpr double kBesideEnd_mm = 2.0;
  const auto valleys = lookahead::valleys(scan, lookahead::breaking_points(scan, 0.0));
  std::vector<MethodPlace> places{{scan.front().s_mm, scan.front().v_mm_s}};
  for (const std::size_t i : valleys) {
    const double to_end =
        std::min(scan[i].s_mm - scan.front().s_mm, scan.back().s_mm - scan[i].s_mm);
    if (i != 0 && i + 1 != scan.size() && (dips || to_end > kBesideEnd_mm)) {
      places.push_back({scan[i].s_mm, scan[i].v_mm_s});
    }
  }
  places.push_back({scan.back().s_mm, scan.back().v_mm_s});
  return places;
}

// No end is faster than what the other allows over the distance.
void adjust(std::vector<MethodPlace>& places, const profiles::Profile& profile,
            const RampLimits& ramp) {
  const auto bind = [&](const MethodPlace& from, MethodPlace& to) {
    to.v_mm_s = std::min(to.v_mm_s, profile.reach_mm_s({.v_mm_s = from.v_mm_s,
                                                        .length_mm = std::abs(to.s_mm - from.s_mm),
                                                        .v_cap_mm_s = to.v_mm_s},
                                                       ramp));
  };
  for (std::size_t i = 1; i < places.size(); ++i) {
    bind(places[i - 1], places[i]);
  }
  for (std::size_t i = places.size() - 1; i > 0; --i) {
    bind(places[i], places[i - 1]);
  }
}

std::vector<Transition> transitions_of(std::vector<MethodPlace> places,
                                       const profiles::Profile& profile,
                                       const lookahead::PlanLimits& limits) {
  const RampLimits ramp{.acceleration_mm_s2 = limits.path.acceleration_mm_s2,
                        .jerk_mm_s3 = limits.path.jerk_mm_s3};
  adjust(places, profile, ramp);
  std::vector<Transition> parts;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Ramp ends{places[i - 1].v_mm_s, places[i].v_mm_s};
    const double length = places[i].s_mm - places[i - 1].s_mm;
    const double v = profile.peak_mm_s(
        ends, {.length_mm = length, .v_cap_mm_s = limits.path.velocity_mm_s}, ramp);
    const Transition up = profile.fastest({ends.v_begin_mm_s, v}, ramp);
    const Transition down = profile.fastest({v, ends.v_end_mm_s}, ramp);
    parts.push_back(up);
    parts.push_back(
        Transition::cruise(v, std::max(length - up.length_mm() - down.length_mm(), 0.0)));
    parts.push_back(down);
  }
  return parts;
}

double duration_s(const std::vector<Transition>& parts) {
  double sum_s = 0.0;
  for (const Transition& part : parts) {
    sum_s += part.duration_s();
  }
  return sum_s;
}

double s_at(const std::vector<Transition>& parts, double t_s) {
  double s = 0.0;
  for (const Transition& part : parts) {
    if (t_s <= part.duration_s()) {
      return s + part.at(t_s).s_mm;
    }
    t_s -= part.duration_s();
    s += part.length_mm();
  }
  return s;
}

}  // namespace

VelocityLimitCurve method_scan(const MethodCurve& curve, ChordRule rule,
                               const lookahead::PlanLimits& limits) {
  constexpr double kRounding = 1e-9;
  const ParametricCurve& walk = curve.by_parameter;
  // Of the tolerance and the tick's error.
  const auto share_of = [&](double from, double to) {
    return limits.chord_tolerance_mm / error_mm(walk, rule, from, to);
  };
  VelocityLimitCurve scan;
  double u = walk.u_begin();
  while (u < walk.u_end()) {
    double v = limits.path.velocity_mm_s;
    double next = walk.step(u, v * limits.period_s);
    while (share_of(u, next) < 1.0 - kRounding) {
      v *= std::min(std::sqrt(share_of(u, next)), 1.0 - kRounding);
      next = walk.step(u, v * limits.period_s);
    }
    scan.push_back({.u = u, .s_mm = curve.by_length.s_at(u), .v_mm_s = v});
    u = next;
  }
  scan.push_back({.u = u, .s_mm = curve.by_length.length_mm(), .v_mm_s = scan.back().v_mm_s});
  return scan;
}

double time_over_s(std::vector<MethodPlace> places, const profiles::Profile& profile,
                   const lookahead::PlanLimits& limits) {
  return duration_s(transitions_of(std::move(places), profile, limits));
}

MethodPlan method_plan(const MethodCurve& curve, const VelocityLimitCurve& scan,
                       const profiles::Profile& profile, const lookahead::PlanLimits& limits,
                       bool dips) {
  const std::vector<Transition> parts = transitions_of(places_of(scan, dips), profile, limits);
  MethodPlan plan{.time_s = duration_s(parts)};
  const auto u_at = [&](double s_mm) {
    const curves::NurbsCurve& by_length = curve.by_length;
    return by_length.pieces()[by_length.piece_index(s_mm)].u_at(s_mm);
  };
  double u = u_at(0.0);
  for (plan.ticks = 1; static_cast<double>(plan.ticks) * limits.period_s < plan.time_s;
       ++plan.ticks) {
    const double next = u_at(s_at(parts, static_cast<double>(plan.ticks) * limits.period_s));
    plan.chord_error_mm = std::max(plan.chord_error_mm, curve.by_parameter.chord_error_mm(u, next));
    u = next;
  }
  return plan;
}

}  // namespace kerf::bench
