#include "lookahead/classical/segment_junction.hpp"

#include <algorithm>

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

}  // namespace

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
