// Whether a change of feedrate keeps the limits of each axis where it lies on the curve.
#pragma once

#include <array>

#include "lookahead/classical/axis_limit_scan.hpp"
#include "lookahead/path/limits.hpp"
#include "profiles/transition.hpp"

namespace kerf::lookahead {

// A ramp from a foot: forwards along the curve, or a deceleration to the foot seen backwards in
// time.
struct PlacedRamp {
  const profiles::Transition& law;
  double foot_mm = 0.0;    // on the block's curve
  double direction = 1.0;  // of the ramp: 1 or -1
};

// By what a ramp would have to be gentler; 1: it holds.
struct RampReduction {
  double acceleration = 1.0;  // factors <= 1 on its acceleration and its jerk, both to be taken
  double jerk = 1.0;
  double stretch = 1.0;  // or a factor >= 1 on its duration

  [[nodiscard]] bool holds() const noexcept { return stretch == 1.0; }
};

// |q' a + q'' v^2| <= A and |q' j + 3 q'' v a + q''' v^3| + jumps v^2 <= J of each axis, signs
// included, at the places of the samples under the ramp and at its instants (ramp_instants.hpp).
// What a place asks for is what would do there; at another length the ramp meets other places.
// Precondition: the ramp is below what curvature allows (PathSample::feedrate_mm_s) but for
// rounding.
RampReduction ramp_reduction(const PlacedRamp& ramp, const AxisLimitCurve& axis_limits,
                             const std::array<MotionLimits, 3>& axes);

}  // namespace kerf::lookahead
