#include "lookahead/classical/segment_junction.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

using profiles::ProfileKind;

namespace {

constexpr double kBelowRounding = 1.0 - 1e-9;

// By how much the mean of a tick that begins with the ramp of a segment is above its beginning.
double gain_in_tick_mm_s(const VelocitySegment& segment, const JunctionRules& rules) {
  const double period_s = rules.limits.period_s;
  const double by_acceleration = 0.5 * segment.limits.ramp.acceleration_mm_s2 * period_s;
  const double by_jerk = segment.limits.ramp.jerk_mm_s3 * period_s * period_s / 6.0;
  return rules.profile.kind() == ProfileKind::trapezoid ? by_acceleration
                                                        : std::min(by_acceleration, by_jerk);
}

// Beside the segment, at the feedrate of the junction with one that speeds up away from it.
double constant_velocity_beside_s(const Block& block, double v_junction_mm_s,
                                  const VelocitySegment& speeding_up, const JunctionRules& rules) {
  const double fastest_mm_s = v_junction_mm_s + gain_in_tick_mm_s(speeding_up, rules);
  return sub_tick_feedrate_mm_s(block, rules.limits) < fastest_mm_s ? rules.limits.period_s : 0.0;
}

void fit_constant_velocity(double constant_velocity_s, const VelocitySegment& segment,
                           double& v_mm_s) {
  if (constant_velocity_s > 0.0) {
    v_mm_s = std::min(v_mm_s, kBelowRounding * 0.5 * segment.length_mm / constant_velocity_s);
  }
}

constexpr int kRounds =
    3;  // the way of the parts at constant velocity and the part of jumps follow the feedrate
constexpr double kWider = 1.1;

struct Largest {
  curves::Position second_per_mm{};
  double third_per_mm2 = 0.0;
};

struct ConstantVelocity {
  double v_mm_s = 0.0;
  double duration_s = 0.0;
};

// Of the axes, within a part at constant velocity from the place.
Largest largest_near(double place_mm, const VelocitySegment& segment,
                     const ConstantVelocity& constant_velocity) {
  Largest largest;
  const double reach_mm = kWider * constant_velocity.v_mm_s * constant_velocity.duration_s;
  const AxisLimitCurve& axis_limits = segment.axis_limits;
  for (std::size_t i = 0; i < axis_limits.size(); ++i) {
    const PathSample& at = axis_limits[i];
    const bool before = i + 1 < axis_limits.size() && axis_limits[i + 1].s_mm < place_mm - reach_mm;
    const bool behind = i > 0 && axis_limits[i - 1].s_mm > place_mm + reach_mm;
    for (std::size_t k = 0; k < 3 && !before && !behind; ++k) {
      double& second = largest.second_per_mm[k];
      second = std::max(second, std::abs(at.second_per_mm[k]));
      largest.third_per_mm2 =
          std::max(largest.third_per_mm2,
                   std::abs(at.third_per_mm2[k]) + at.jumps_per_mm_s[k] / constant_velocity.v_mm_s);
    }
  }
  return largest;
}

}  // namespace

Junction beside_axis_limits(const Junction& found, const JunctionSides& sides,
                            const PlanLimits& limits) {
  Junction junction = found;
  if (junction.feedrate_mm_s == 0.0 || junction.constant_velocity_s == 0.0) {
    return junction;
  }
  double& v = junction.feedrate_mm_s;
  for (const VelocitySegment* segment : {sides.before, sides.after}) {
    if (!segment->axis_limits.empty()) {
      fit_constant_velocity(junction.constant_velocity_s, *segment, v);
    }
  }
  for (int i = 0; i < kRounds; ++i) {
    const ConstantVelocity constant_velocity{.v_mm_s = v,
                                             .duration_s = junction.constant_velocity_s};
    const double end_mm = sides.before->s_begin_mm + sides.before->length_mm;
    const Largest before = largest_near(end_mm, *sides.before, constant_velocity);
    const Largest after = largest_near(sides.after->s_begin_mm, *sides.after, constant_velocity);
    BlockEnd end = sides.blocks.before->end;
    BlockEnd begin = sides.blocks.after->begin;
    end.max_third_per_mm2 = std::max(end.max_third_per_mm2, before.third_per_mm2);
    begin.max_third_per_mm2 = std::max(begin.max_third_per_mm2, after.third_per_mm2);
    const double jerk = corner_feedrate_mm_s(end, begin, limits);
    for (std::size_t k = 0; k < 3; ++k) {
      end.second_per_mm[k] = begin.second_per_mm[k] =
          std::max({std::abs(end.second_per_mm[k]), std::abs(begin.second_per_mm[k]),
                    before.second_per_mm[k], after.second_per_mm[k]});
    }
    v = std::min({v, jerk, corner_feedrate_mm_s(end, begin, limits)});
  }
  return junction;
}

double valley_mm_s(double limit_mm_s, const VelocitySegment& segment, const JunctionRules& rules) {
  if (rules.profile.kind() != ProfileKind::trapezoid) {
    return limit_mm_s;
  }
  const double rise = 0.25 * segment.limits.ramp.acceleration_mm_s2 * rules.limits.period_s;
  return std::max(limit_mm_s - rise, 0.5 * limit_mm_s);
}

SegmentJunction segment_junction(const JunctionSides& sides, const JunctionRules& rules) {
  const Block& before = *sides.blocks.before;
  const Block& after = *sides.blocks.after;
  Junction junction = junction_of(sides.blocks, rules.limits);
  double& v = junction.feedrate_mm_s;
  if (!before.limit_curve.empty()) {
    const double end_mm_s =
        std::min(before.limit_curve.back().v_mm_s, sides.before->fall.bottom_mm_s());
    v = std::min(v, valley_mm_s(end_mm_s, *sides.before, rules));
  }
  if (!after.limit_curve.empty()) {
    const double begin_mm_s =
        std::min(after.limit_curve.front().v_mm_s, sides.after->rise.bottom_mm_s());
    v = std::min(v, valley_mm_s(begin_mm_s, *sides.after, rules));
  }
  if (junction.constant_velocity_s > 0.0) {
    const bool curved = !sides.before->axis_limits.empty() || !sides.after->axis_limits.empty();
    junction = curved ? beside_axis_limits(junction, sides, rules.limits) : junction;
  }
  v = std::min({v, sub_tick_feedrate_mm_s(before, rules.limits),
                sub_tick_feedrate_mm_s(after, rules.limits)});
  if (junction.constant_velocity_s > 0.0 || v == 0.0) {
    return {.end = junction, .begin_constant_velocity_s = junction.constant_velocity_s};
  }
  const double begin_constant_velocity_s =
      constant_velocity_beside_s(before, v, *sides.after, rules);
  junction.constant_velocity_s = constant_velocity_beside_s(after, v, *sides.before, rules);
  fit_constant_velocity(junction.constant_velocity_s, *sides.before, v);
  fit_constant_velocity(begin_constant_velocity_s, *sides.after, v);
  return {.end = junction, .begin_constant_velocity_s = begin_constant_velocity_s};
}

}  // namespace kerf::lookahead
