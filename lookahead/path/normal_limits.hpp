// The limits of acceleration and jerk across the path, as limits of the feedrate.
#pragma once

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/block_limits.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// On a circle of curvature k at constant feedrate v acceleration is k v^2 and jerk k^2 v^3; so
// v <= sqrt(A / k) and v <= cbrt(J / k^2) [LeeEtAl]. The lower one; unbounded on a straight path.
Bound normal_bound(double curvature_per_mm, const PlanLimits& limits);

// No place of the limit curve is higher than that: to less than a thousandth below it, nowhere
// above. As it was where neither limit is set.
void lower_to_normal_limits(const curves::NurbsCurve& curve, const PlanLimits& limits,
                            VelocityLimitCurve& limit_curve);

}  // namespace kerf::lookahead
