// How fast a junction may be passed beside a curve where limits of axes bind.
#pragma once

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

// The segments on both sides of a junction, and what they are part of.
struct JunctionSides {
  JunctionQuery blocks{};
  const VelocitySegment* before = nullptr;
  const VelocitySegment* after = nullptr;
};

// junction_of() knows a curve at its end alone and leaves nothing for what curvature asks of the
// axes within the ticks that see the junction. Here it is asked again, with the largest second and
// third derivative within the parts at constant velocity, and both parts at constant velocity fit
// into half a segment. Never faster than found.
Junction beside_axis_limits(const Junction& found, const JunctionSides& sides,
                            const PlanLimits& limits);

}  // namespace kerf::lookahead
