// Checks whether a change of feedrate keeps the limits of each axis at its place on the curve.
#pragma once

#include <array>
#include <vector>

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/path/limits.hpp"
#include "profiles/transition.hpp"

namespace kerf::lookahead {

// A ramp from its slower end, the foot: forwards along the curve, or a deceleration to the foot
// seen backwards in time.
struct PlacedRamp {
  const profiles::Transition& law;
  double foot_mm = 0.0;    // on the block's curve
  double direction = 1.0;  // of the ramp: 1 or -1
};

// How much gentler a ramp must be; 1: it keeps the limits.
struct RampReduction {
  double acceleration = 1.0;  // factors <= 1 on its acceleration and its jerk; apply both
  double jerk = 1.0;
  double stretch = 1.0;  // or a factor >= 1 on its duration

  [[nodiscard]] bool holds() const noexcept { return stretch == 1.0; }
};

// |q' a + q'' v^2| <= A and |q' j + 3 q'' v a + q''' v^3| + jumps v^2 <= J of each axis, signs
// included, at the places of the samples under the ramp and at its instants (instants_of).
// The factors suffice for these places; with another length the ramp meets other places.
// Precondition: the ramp is below what curvature allows (PathSample::feedrate_mm_s) but for
// rounding.
RampReduction ramp_reduction(const PlacedRamp& ramp, const AxisLimitCurve& axis_limits,
                             const std::array<MotionLimits, 3>& axes);

// An instant of a ramp; where its acceleration has a corner its jerk has two values.
struct Instant {
  double t_s = 0.0;
  profiles::PathMotion motion{};
  double j_before_mm_s3 = 0.0;
  double j_after_mm_s3 = 0.0;
};

// Ascending, from the beginning to the end of the law, which rises: some hundred, closer to each
// other at both ends; where between them its jerk is highest; and where its acceleration has a
// corner or bends so much that a straight line between two instants would differ from it.
std::vector<Instant> instants_of(const profiles::Transition& law);

// The motion between two neighbours. Acceleration is linear over time there, as that of an S-curve
// is; of the other laws it misses less than a 400th. (Over distance it is not linear, nor is the
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
  double jerk_mm_s3_;
  double scale_ = 1.0;
};

}  // namespace kerf::lookahead
