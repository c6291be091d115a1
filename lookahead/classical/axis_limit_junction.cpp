#include "lookahead/classical/axis_limit_junction.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

namespace {

constexpr int kRounds =
    3;  // the way of the parts at constant velocity and the part of jumps follow the feedrate
constexpr double kWider = 1.1;
constexpr double kBelowRounding = 1.0 - 1e-9;

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
      v = std::min(v, kBelowRounding * 0.5 * segment->length_mm / junction.constant_velocity_s);
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
    end.third_per_mm2 = std::max(end.third_per_mm2, before.third_per_mm2);
    begin.third_per_mm2 = std::max(begin.third_per_mm2, after.third_per_mm2);
    const double jerk = corner_feedrate_mm_s(end, begin, limits);
    for (std::size_t k = 0; k < 3; ++k) {
      end.curvature_per_mm[k] = begin.curvature_per_mm[k] =
          std::max({std::abs(end.curvature_per_mm[k]), std::abs(begin.curvature_per_mm[k]),
                    before.second_per_mm[k], after.second_per_mm[k]});
    }
    v = std::min({v, jerk, corner_feedrate_mm_s(end, begin, limits)});
  }
  return junction;
}

}  // namespace kerf::lookahead
