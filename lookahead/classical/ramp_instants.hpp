// When a ramp is looked at, to see whether it keeps the limits of each axis (axis_limit_check.hpp).
#pragma once

#include <vector>

#include "profiles/transition.hpp"

namespace kerf::lookahead {

// Of a ramp; where its acceleration has a corner its jerk has two values.
struct Instant {
  double t_s = 0.0;
  profiles::PathMotion motion{};
  double j_before_mm_s3 = 0.0;
  double j_after_mm_s3 = 0.0;
};

// Ascending, from the beginning to the end of the law, which rises: some hundred, closer to each
// other at both ends; where between them its jerk is highest; and where its acceleration has a
// corner or bends so much that a straight line between two instants would miss it.
std::vector<Instant> instants_of(const profiles::Transition& law);

// The motion between two neighbours. Acceleration is linear over time there, as that of an S-curve
// is; of the other laws it misses less than a 400th. (Over the way it is not linear, nor is the
// feedrate: near a slow foot the difference is large.)
class BetweenInstants {
 public:
  BetweenInstants(const Instant& from, const Instant& to);

  // Without its jerk. distance_mm: from the foot of the ramp, between those of the two.
  [[nodiscard]] profiles::PathMotion at(double distance_mm) const;

 private:
  [[nodiscard]] double way_after_mm(double t_s) const;
  [[nodiscard]] double feedrate_after_mm_s(double t_s) const;

  profiles::PathMotion from_;
  double duration_s_;
  double jerk_mm_s3_ = 0.0;
  double scale_ = 1.0;
};

}  // namespace kerf::lookahead
