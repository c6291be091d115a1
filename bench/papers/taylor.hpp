// Interpolation by Taylor's series of second order, as the papers do it, of the way
// that the plan goes in each tick: what the series adds by itself.
#pragma once

#include "bench/papers/in_motion.hpp"
#include "bench/papers/parametric_curve.hpp"

namespace kerf::bench {

struct TaylorRun {
  double drift_mm = 0.0;          // the largest distance along the path from where the plan is
  double arc_jerk_mm_s3 = 0.0;    // third differences of the arc lengths between its points
  double chord_jerk_mm_s3 = 0.0;  // and of the chords
};

TaylorRun taylor_of(const MotionRun& run, const ParametricCurve& curve, double period_s);

}  // namespace kerf::bench
