// Finds the cruise of a segment under a limit curve.
#pragma once

#include "lookahead/classical/acceleration_ramp.hpp"
#include "lookahead/classical/velocity_segment.hpp"

namespace kerf::lookahead {

// The ramps on both sides of a cruise.
struct CruiseSides {
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

  [[nodiscard]] double best_mm_s() const;
  [[nodiscard]] CruiseSides sides(double cruise_mm_s) const;

 private:
  struct Bracket {
    double low_mm_s = 0.0;
    double high_mm_s = 0.0;
  };

  [[nodiscard]] double spare_mm(const CruiseSides& sides) const;
  [[nodiscard]] double time_s(double cruise_mm_s) const;
  [[nodiscard]] double fastest_in(const Bracket& cruise) const;

  const VelocitySegment& segment_;
  const SegmentEnds& ends_;
  double length_mm_;
  const profiles::Profile& profile_;
};

}  // namespace kerf::lookahead
