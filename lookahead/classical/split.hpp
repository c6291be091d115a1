// Splits blocks into segments: a curve is cut at the valleys of its velocity limit curve, and where
// one ramp from a valley would crawl (limit_curve_cuts.hpp).
#pragma once

#include <vector>

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// The segments of a block in order; the junction at the last one's end is still open (a stop).
// Valleys within a tick's distance at their feedrate count as one, and a valley as close to an end
// does not count: beside a corner that is almost smooth, derivatives are rounding errors with
// thousands of valleys.
std::vector<VelocitySegment> split(const Block& block, double period_s);
struct CurvatureDemands {
  const AxisLimitCurve& axis_limits;
  const PlanLimits& limits;
};
// The same with the demands of curvature on the axes, which lower the limit curve and stay with
// each segment. A valley that is lower than the places beside it by less than height, a share of
// the feedrate, does not count. Precondition: the block is a NURBS with its limit curve;
// axis_limits is not empty.
std::vector<VelocitySegment> split(const Block& block, const CurvatureDemands& demands,
                                   double height);
// The same for a block without a limit curve, which is one segment.
VelocitySegment whole_segment(const Block& block);

}  // namespace kerf::lookahead
