// The plateau of a segment under a ceiling.
#pragma once

#include "lookahead/classical/acceleration_ramp.hpp"
#include "lookahead/classical/velocity_segment.hpp"

namespace kerf::lookahead {

// Both sides of a plateau.
struct PlateauSides {
  AccelerationRamp up{};
  AccelerationRamp down_mirrored{};  // accelerates from the end's feedrate
};

// Under a ceiling a higher plateau asks for gentler slopes, so the highest is not the fastest:
// bisect for the highest that fits, then search the least time below it. Weakness: takes time over
// the plateau to fall and then to rise, with one valley between.
class PlateauSearch {
 public:
  // length_mm: of the segment without its coasts. Keeps references: lives no longer than its
  // arguments.
  PlateauSearch(const VelocitySegment& segment, const SegmentEnds& ends, double length_mm,
                const profiles::Profile& profile)
      : segment_(segment), ends_(ends), length_mm_(length_mm), profile_(profile) {}

  [[nodiscard]] double best_mm_s() const;
  [[nodiscard]] PlateauSides sides(double plateau_mm_s) const;

 private:
  struct Bracket {
    double low_mm_s = 0.0;
    double high_mm_s = 0.0;
  };

  [[nodiscard]] double spare_mm(const PlateauSides& sides) const;
  [[nodiscard]] double time_s(double plateau_mm_s) const;
  [[nodiscard]] double fastest_in(const Bracket& plateau) const;

  const VelocitySegment& segment_;
  const SegmentEnds& ends_;
  double length_mm_;
  const profiles::Profile& profile_;
};

}  // namespace kerf::lookahead
