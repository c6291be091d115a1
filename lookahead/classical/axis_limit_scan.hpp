// The demands of a curve's curvature on each axis, place by place.
#pragma once

#include <vector>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// s ascends; linear between samples. Where derivatives jump, two samples share their s.
using AxisLimitCurve = std::vector<PathSample>;

// An axis sees q' a + q'' v^2 as acceleration and q' j + 3 q'' v a + q''' v^3 as jerk. At constant
// feedrate the terms with q'' and q''' remain, which may take a share of the axis' limits; the rest
// is for changes of the feedrate (axis_limit_check.hpp). Where curvature jumps by dk, the axis'
// acceleration steps by v^2 dk, of which a third difference over Ts sees 3/4 v^2 |dk| / Ts at the
// most as jerk (junction.hpp): within three ticks of the place that counts as jerk of curvature.
//
// Each piece of the curve is halved until straight lines between samples differ from derivatives
// and feedrate by no more than a part of the limits that the check leaves free.
//
// feedrate_mm_s: the highest of interest. Empty where no axis has a limit.
AxisLimitCurve scan_axis_limits(const curves::NurbsCurve& curve, double feedrate_mm_s,
                                const PlanLimits& limits);

// The lower of a limit curve and the feedrate that curvature allows.
VelocityLimitCurve lower_limit_curve(const VelocityLimitCurve& limit_curve,
                                     const AxisLimitCurve& axis_limits);

}  // namespace kerf::lookahead
