// Blocks to segments: a curve is cut at the valleys of the feedrate it allows, and where one ramp
// from a valley would crawl (limit_curve_cuts.hpp).
#pragma once

#include <vector>

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// The segments of a block in order; the junction at the last one's end is still open (a stop).
// Valleys within a tick's way at their feedrate are one, and one as close to an end is none: beside
// a corner that is not quite one, derivatives are rounding, and rounding has thousands of valleys.
std::vector<VelocitySegment> split(const Block& block, double period_s);
// The same with what curvature asks of the axes, which lowers the limit curve and stays with each
// segment. Precondition: the block is a NURBS with its limit curve; axis_limits is not empty.
std::vector<VelocitySegment> split(const Block& block, const AxisLimitCurve& axis_limits,
                                   const PlanLimits& limits);
// The same for a block without a limit curve, which is one segment.
VelocitySegment whole_segment(const Block& block);

}  // namespace kerf::lookahead
