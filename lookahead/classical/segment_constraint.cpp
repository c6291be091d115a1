#include "lookahead/classical/segment_constraint.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

using interp::active_constraint;
using profiles::ProfileKind;
using profiles::RampLimits;
using profiles::Transition;

namespace {

constexpr double kAlike = 1e-6;  // what differs less is rounding
constexpr int kPlaces = 16;      // of a law under a limit curve
constexpr double kMore = 1.01;   // of a limit, to see what it is worth
}  // namespace

ActiveConstraint SegmentConstraint::of(SegmentPart part, const Transition& law,
                                       double s_begin_mm) const {
  switch (part) {
    case SegmentPart::begin_constant_velocity:
      return constant_velocity(of_.segment->begin_constant_velocity_s, law, s_begin_mm);
    case SegmentPart::end_constant_velocity:
      return constant_velocity(of_.segment->end.constant_velocity_s, law, s_begin_mm);
    case SegmentPart::cruise:
      return cruise(law, s_begin_mm);
    case SegmentPart::deceleration:
      return of_.brakes_for_window ? active_constraint(Constraint::window_end)
                                   : ramp(law, s_begin_mm);
    case SegmentPart::acceleration:
      break;
  }
  return ramp(law, s_begin_mm);
}

ActiveConstraint SegmentConstraint::limit_curve(const Transition& law, double s_begin_mm) const {
  const VelocityLimitCurve& curve = of_.block->limit_curve;
  const auto sample_at = [&curve](double s_mm) {
    return *std::ranges::lower_bound(curve.begin(), curve.end() - 1, s_mm, {}, &FeedSample::s_mm);
  };
  FeedSample nearest;
  double share = 0.0;
  for (int k = 0; k <= kPlaces; ++k) {
    const profiles::PathMotion motion = law.at(law.duration_s() * k / kPlaces);
    const FeedSample sample = sample_at(s_begin_mm + motion.s_mm);
    if (motion.v_mm_s > share * sample.v_mm_s) {
      nearest = sample;
      share = motion.v_mm_s / sample.v_mm_s;
    }
    if (const PathSample* axis = axis_limit_at(s_begin_mm + motion.s_mm);
        axis != nullptr && motion.v_mm_s > share * axis->feedrate_mm_s) {
      nearest.limit = axis->limit;
      share = motion.v_mm_s / axis->feedrate_mm_s;
    }
  }
  return active_constraint(nearest.limit);
}

const PathSample* SegmentConstraint::axis_limit_at(double s_mm) const {
  const AxisLimitCurve& axis_limits = of_.segment->axis_limits;
  const auto found = std::ranges::lower_bound(axis_limits, s_mm, {}, &PathSample::s_mm);
  return found == axis_limits.end() ? nullptr : &*found;
}

ActiveConstraint SegmentConstraint::constant_velocity(double constant_velocity_s,
                                                      const Transition& law,
                                                      double s_begin_mm) const {
  return constant_velocity_s > 0.0 || of_.block->limit_curve.empty()
             ? active_constraint(Constraint::junction)
             : limit_curve(law, s_begin_mm);
}

ActiveConstraint SegmentConstraint::cruise(const Transition& law, double s_begin_mm) const {
  if (law.ramp().v_begin_mm_s >= (1.0 - kAlike) * of_.block->limits.feedrate_mm_s) {
    return active_constraint(of_.block->limits.from.feedrate);
  }
  if (of_.segment->limits.from.feedrate != of_.block->limits.from.feedrate &&
      law.ramp().v_begin_mm_s >= (1.0 - kAlike) * of_.segment->limits.feedrate_mm_s) {
    return active_constraint(of_.segment->limits.from.feedrate);
  }
  return of_.block->limit_curve.empty() ? active_constraint(of_.block->limits.from.jerk)
                                        : limit_curve(law, s_begin_mm);
}

ActiveConstraint SegmentConstraint::ramp(const Transition& law, double s_begin_mm) const {
  const RampLimits& limits = of_.segment->limits.ramp;
  const LimitOrigins& from = of_.block->limits.from;
  const double change = law.ramp().v_end_mm_s - law.ramp().v_begin_mm_s;
  if (!of_.segment->rise.empty() &&
      law.duration_s() > (1.0 + kAlike) * of_.profile->duration_s(change, limits)) {
    return limit_curve(law, s_begin_mm);
  }
  const double a = limits.acceleration_mm_s2;
  const double j = limits.jerk_mm_s3;
  switch (of_.profile->kind()) {
    case ProfileKind::trapezoid:
      return active_constraint(from.acceleration);
    case ProfileKind::s_curve:
    case ProfileKind::time_optimal:
      return {.limit = from.jerk,
              .steady = std::abs(change) * j > a * a ? from.acceleration : from.jerk};
    case ProfileKind::sine:
    case ProfileKind::quintic:
    case ProfileKind::sine_series:
    case ProfileKind::sigmoid:
      break;
  }
  const double with_more_a = of_.profile->duration_s(change, {kMore * a, j});
  const double with_more_j = of_.profile->duration_s(change, {a, kMore * j});
  return active_constraint(with_more_a < with_more_j ? from.acceleration : from.jerk);
}

}  // namespace kerf::lookahead
