// The feedrate that both the chord error and the axes allow.
#pragma once

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/path/velocity_limit_curve.hpp"

namespace kerf::lookahead {

// The lower one of a limit curve and what curvature allows.
VelocityLimitCurve lower_limit_curve(const VelocityLimitCurve& limit_curve,
                                     const AxisLimitCurve& axis_limits);

}  // namespace kerf::lookahead
