// The ramps of a segment below its limit curve, and the cruise between them.
#pragma once

#include <cstdint>
#include <optional>

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

// A ramp in a segment: it ascends from the feedrate at that end. room_mm is its length without the
// parts at constant velocity; a ramp that needs more does not fit, and how much more is not known.
struct RampRequest {
  SegmentSide side = SegmentSide::rise;
  profiles::Ramp ramp{};
  double room_mm = kUnbounded;
  bool may_wait = false;  // at its slower end until curvature has eased, where that saves time
};

// The fastest transition over the ramp, stretched until it stays below the slope; that of a
// trapezoid begins later instead.
//
// Where curvature binds, it is made gentler until it keeps the limits of each axis at every place
// on it: the S-curve gets its own acceleration and jerk, the other laws are stretched, a trapezoid
// gets its own acceleration. Each round takes what the places needed in the round before, so the
// result is gentler than necessary. Known weaknesses: one acceleration for all of a ramp, and a
// ramp to a lower feedrate may come out longer, since it meets other places.
AccelerationRamp acceleration_ramp(const RampRequest& request, const VelocitySegment& segment,
                                   const profiles::Profile& profile);

// A length that this ramp has at least, at much less cost.
double least_length_mm(const RampRequest& request, const VelocitySegment& segment,
                       const profiles::Profile& profile);

// The length of that ramp, cheaper where there is no slope.
double ramp_length_mm(const RampRequest& request, const VelocitySegment& segment,
                      const profiles::Profile& profile);

// The ramps on both sides of a cruise.
struct Cruise {
  double v_mm_s = 0.0;
  AccelerationRamp up{};
  AccelerationRamp down_mirrored{};  // accelerates from the end's feedrate
};

// Under a limit curve a higher cruise asks for gentler slopes, so the highest is not the fastest:
// bisect for the highest that fits, then search the least time below it. Weakness: takes time over
// the cruise to fall and then to rise, with one valley between.
class CruiseSearch {
 public:
  // length_mm: of the segment without its parts at constant velocity. Keeps references: lives no
  // longer than its arguments.
  CruiseSearch(const VelocitySegment& segment, const SegmentEnds& ends, double length_mm,
               const profiles::Profile& profile)
      : segment_(segment), ends_(ends), length_mm_(length_mm), profile_(profile) {}

  [[nodiscard]] Cruise best() const;

 private:
  struct Timed {
    Cruise cruise{};
    double time_s = kUnbounded;
  };

  [[nodiscard]] Cruise cruise_at(double v_mm_s) const;
  // None where it does not fit.
  [[nodiscard]] std::optional<Cruise> fitting(double v_mm_s) const;
  [[nodiscard]] RampRequest side(SegmentSide side, double v_mm_s) const;
  [[nodiscard]] double spare_mm(const Cruise& cruise) const;
  [[nodiscard]] double time_s(const Cruise& cruise) const;
  [[nodiscard]] Timed timed(double v_mm_s) const;
  // low_mm_s: the lowest cruise of interest.
  [[nodiscard]] Cruise fastest_below(const Cruise& highest, double low_mm_s) const;

  const VelocitySegment& segment_;
  const SegmentEnds& ends_;
  double length_mm_;
  const profiles::Profile& profile_;
};

}  // namespace kerf::lookahead
