// The chord-error scan: how fast a curve may be run at each of its points.
#pragma once

#include "curves/nurbs_curve.hpp"
#include "lookahead/ceiling.hpp"
#include "lookahead/limits.hpp"

namespace kerf::lookahead {

// Where a curve is nearly straight the classical profiles see the ceiling at every half tick (their
// breaking points are found by its slopes), the time optimum at the quarters of a piece.
enum class ScanSteps { half_ticks, quarter_pieces };

struct ScanLimits {
  double feedrate_mm_s = kUnbounded;
  SpeedLimit feedrate_from = SpeedLimit::programmed;
  double jerk_mm_s3 = kUnbounded;  // along the path, and of each axis
  curves::Position axis_jerk_mm_s3{kUnbounded, kUnbounded, kUnbounded};
  double period_s = 0.001;
  double chord_tolerance_mm = kUnbounded;
  ScanSteps steps = ScanSteps::half_ticks;
};

// Walks the curve; at each place begins with the feedrate that the curvature there allows, measures
// the chord error of the tick and shrinks the feedrate with the square root of its excess until it
// fits (Sigmoid, section 3.1; MATH section 5). It is never below what goes as far as the tolerance
// in a tick: no turn, however sharp, makes a chord error of that. The walk goes by arc length, so a
// step needs no Taylor series.
//
// A tick judged at its start s covers [s, s + v Ts]; what it bounds is its mean feedrate, which is
// the feedrate at its middle in time but for J Ts^2 / 24. So the sample stands at s + v Ts / 2,
// less that difference, and a plan below the samples keeps the tolerance wherever its ticks fall.
// Steps are half a tick, and no longer than a quarter of a piece of the arc-length map, which is
// short where the curve is sharp; no feature is stepped over. Where a tick is far shorter than
// that and curvature allows many times the feedrate, they are a 64th of it; in steps of quarter
// pieces they are a whole one where curvature allows twice the feedrate all over it. Between
// samples the ceiling is a straight line: where the bound lies below it (curvature jumps, or is
// about to), the steps are halved until it hardly does. Known to hold to a thousandth of the
// tolerance on the shipped curves.
Ceiling scan_feedrate(const curves::NurbsCurve& curve, const ScanLimits& limits);

}  // namespace kerf::lookahead
