// How the segments of two blocks join in the classical schedule.
#pragma once

#include "lookahead/classical/velocity_segment.hpp"
#include "lookahead/path/junction.hpp"
#include "profiles/profile.hpp"

namespace kerf::lookahead {

// The segments on both sides of a junction, and what they are part of.
struct JunctionSides {
  JunctionQuery blocks{};
  const VelocitySegment* before = nullptr;
  const VelocitySegment* after = nullptr;
};

// junction_of() knows a curve only at its end and leaves nothing for the demands of curvature on
// the axes within the ticks that see the junction. This repeats it with the largest second and
// third derivative within the parts at constant velocity, each of which fits into half a segment.
// Never faster than `found`.
Junction beside_axis_limits(const Junction& found, const JunctionSides& sides,
                            const PlanLimits& limits);

struct SegmentJunction {
  Junction end{};                          // of the segment before, with its constant velocity
  double begin_constant_velocity_s = 0.0;  // of the segment after
};

struct JunctionRules {
  const PlanLimits& limits;
  const profiles::Profile& profile;
};

// The limit curve bounds the mean feedrate of a tick. In a valley the acceleration of a law without
// jerk jumps from -A to A, and the mean of the tick around it is A Ts / 4 above its middle at the
// most. No less than half of the limit curve: where A Ts / 4 is more than that, the scan has made
// the limit curve so wide that the tick is all in it.
double valley_mm_s(double limit_mm_s, const VelocitySegment& segment, const JunctionRules& rules);

// The highest feedrate at which both blocks may be passed. Beside a block that one tick might pass
// over faster, a tick at constant velocity is added outside of it, so that no tick that sees the
// whole block includes a part of a ramp.
SegmentJunction segment_junction(const JunctionSides& sides, const JunctionRules& rules);

}  // namespace kerf::lookahead
