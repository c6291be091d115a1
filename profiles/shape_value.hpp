// The normalised transition of every feedrate profile: phi(0) = 0, phi(1) = 1,
// phi(x) + phi(1 - x) = 1 for x in [0, 1].
#pragma once

namespace kerf::profiles {

struct ShapeValue {
  double integral = 0.0;  // of phi from 0 to x; 1/2 at x = 1
  double phi = 0.0;
  double slope = 0.0;      // phi'
  double curvature = 0.0;  // phi''
};

// The limits of a transition. Infinity: the limit does not bind.
struct RampLimits {
  double acceleration_mm_s2 = 0.0;  // > 0
  double jerk_mm_s3 = 0.0;          // > 0
};

struct PathMotion {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
  double j_mm_s3 = 0.0;
};

}  // namespace kerf::profiles
