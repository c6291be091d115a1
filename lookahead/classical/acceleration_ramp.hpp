// Accelerates from an end of a segment, below its limit curve.
#pragma once

#include <cstdint>

#include "lookahead/classical/velocity_segment.hpp"

namespace kerf::lookahead {

// First delay_mm at constant velocity, then the law.
struct AccelerationRamp {
  profiles::Transition law{};
  double delay_mm = 0.0;

  [[nodiscard]] double length_mm() const { return delay_mm + law.length_mm(); }
  [[nodiscard]] double duration_s() const {
    const double v = law.ramp().v_begin_mm_s;
    return law.duration_s() + (delay_mm > 0.0 ? delay_mm / v : 0.0);
  }
};

// Forwards from the begin of a segment, or mirrored from its end.
enum class SegmentSide : std::uint8_t { rise, fall };

// A ramp in a segment: ramp ascends, from the feedrate at that end; room_mm is what it has without
// parts at constant velocity. What needs more does not fit, and how much more is not told then.
struct RampRequest {
  SegmentSide side = SegmentSide::rise;
  profiles::Ramp ramp{};
  double room_mm = kUnbounded;
  bool may_wait = false;  // at its foot until curvature has eased, where that saves time
};

// The fastest transition over the ramp, stretched until it stays below the slope; that of a
// trapezoid begins later instead.
//
// Where curvature binds, it is made gentler until it keeps the limits of each axis at the places
// where it lies: the S-curve gets its own acceleration and jerk, the other laws are stretched, a
// trapezoid gets its own acceleration. Each round takes what the places asked for in the round
// before, so it ends above what would just do. Known weaknesses: one acceleration for all of a
// ramp, and a ramp to a lower feedrate may come out longer, since it meets other places.
AccelerationRamp acceleration_ramp(const RampRequest& request, const VelocitySegment& segment,
                                   const profiles::Profile& profile);

// The length of that ramp, cheaper where there is no slope.
double ramp_length_mm(const RampRequest& request, const VelocitySegment& segment,
                      const profiles::Profile& profile);

}  // namespace kerf::lookahead
