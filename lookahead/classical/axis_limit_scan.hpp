// What the curvature of a curve asks of each axis, place by place.
#pragma once

#include <array>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/velocity_limit_curve.hpp"

namespace kerf::lookahead {

// Derivatives by arc length at one place, and what they leave for a constant feedrate.
struct AxisLimitSample {
  double s_mm = 0.0;
  curves::Position first{};
  curves::Position second_per_mm{};
  curves::Position third_per_mm2{};
  // Of the axes' jerk in mm/s^3 over the feedrate squared: what a third difference of positions
  // sees of jumps of curvature within its reach.
  curves::Position jumps_per_mm_s{};
  double feedrate_mm_s = kUnbounded;
  Constraint limit = Constraint::x_jerk;  // that feedrate_mm_s comes from
};

// s ascends; linear between samples. Where derivatives jump, two samples share their s.
using AxisLimitCurve = std::vector<AxisLimitSample>;

// An axis sees q' a + q'' v^2 as acceleration and q' j + 3 q'' v a + q''' v^3 as jerk. At constant
// feedrate the parts of q'' and q''' remain, which may take a share of the axis' limits; the rest
// is for changes of the feedrate (turn_check.hpp). Where curvature jumps by dk, the axis'
// acceleration steps by v^2 dk, of which a third difference over Ts sees 3/4 v^2 |dk| / Ts at the
// most as jerk (junction.hpp): within three ticks of the place that counts as jerk of curvature.
//
// Each piece of the curve is halved until straight lines between samples miss neither derivatives
// nor feedrate by more than a part of the limits that the check leaves free.
//
// feedrate_mm_s: the highest of interest. Empty where no axis has a limit.
AxisLimitCurve scan_axis_limits(const curves::NurbsCurve& curve, double feedrate_mm_s,
                                const PlanLimits& limits);

}  // namespace kerf::lookahead
