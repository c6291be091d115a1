// The chord-error scan: how fast a curve may be run at each of its points.
#pragma once

#include "lookahead/path/tick_bounds.hpp"
#include "lookahead/path/velocity_limit_curve.hpp"

namespace kerf::lookahead {

// The bounds of ticks as a limit curve of the feedrate. A tick judged at its start s covers
// [s, s + v Ts]; what it bounds is its mean feedrate, which is the feedrate at its middle in time
// but for J Ts^2 / 24. So the sample stands at s + v Ts / 2, less that difference, and a plan below
// the samples keeps the tolerance wherever its ticks fall. Between samples the limit curve is a
// straight line. Known to hold to a thousandth of the tolerance on the shipped curves.
//
// Where that difference, or A Ts / 4 in a valley of a trapezoid, is more than half of the bound,
// the limit curve is no higher than the bound all over [s, s + v Ts]: that way takes a tick then,
// whatever accelerations a plan has.
VelocityLimitCurve scan_feedrate(const curves::NurbsCurve& curve, const ScanLimits& limits);

}  // namespace kerf::lookahead
