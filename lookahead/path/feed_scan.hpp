// The chord-error scan: how far a tick may go from each place of a curve, and so the feedrate
// there.
#pragma once

#include <array>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// The kind of profile that runs below the limit curve. Where a curve is nearly straight the
// classical profiles see the limit curve at every half tick (their breaking points are found by its
// slopes), the time optimum at the quarters of a piece. The acceleration of a trapezoid jumps.
enum class ScanFor { trapezoid, bounded_jerk, time_optimum };

struct ScanLimits {
  double feedrate_mm_s = kUnbounded;
  Constraint feedrate_from = Constraint::programmed;
  // How a plan may accelerate, for scan_feedrate alone. Limits of velocity are in feedrate_mm_s.
  MotionLimits along{};
  std::array<MotionLimits, 3> axes{};
  double period_s = 0.001;
  double chord_tolerance_mm = kUnbounded;
  ScanFor plan = ScanFor::bounded_jerk;
};

// The bound for a tick that begins at s_mm, which is below 0 before the curve.
struct TickBound {
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// Walks the curve; at each place begins with the feedrate that the curvature there allows, measures
// the chord error of the tick and shrinks the feedrate with the square root of its excess until it
// fits ([Sigmoid, section 3.1]; docs/math.md, 4.3). It is never below one tolerance per tick: over
// that distance no turn, however sharp, exceeds the tolerance. The walk goes by arc length, so a
// step needs no Taylor series.
//
// Steps are half a tick, and no longer than a quarter of a piece of the arc-length map, which is
// short where the curve is sharp; none passes over a whole piece of more than 1e-7 mm, and in a
// tick that does the ends of the sharpest are checked: a needle is not stepped over. Where a tick
// is far shorter than that and curvature allows many times the feedrate, they are a 64th of it; in
// steps of quarter pieces they are a whole one where curvature allows twice the feedrate all over
// it. Where the bound lies below a straight line between its neighbours (curvature jumps, or is
// about to), the steps are halved until it hardly does.
//
// Ticks that pass over an end of the curve are included; beyond it the path is taken as
// ContinuedCurve says. They ascend, from half a tick before the curve to its end.
std::vector<TickBound> tick_bounds(const curves::NurbsCurve& curve, const ScanLimits& limits);

// The bounds of ticks as a limit curve of the feedrate. A tick judged at its start s covers
// [s, s + v Ts]; it bounds the mean feedrate, which is the feedrate at its middle in time but for
// J Ts^2 / 24. So the sample stands at s + v Ts / 2, less that difference, and a plan below
// the samples keeps the tolerance wherever its ticks fall. Between samples the limit curve is a
// straight line. Known to hold to a thousandth of the tolerance on the shipped curves.
//
// Where that difference, or A Ts / 4 in a valley of a trapezoid, is more than half of the bound,
// the limit curve is no higher than the bound all over [s, s + v Ts]: that distance takes a tick
// then, whatever accelerations a plan has.
VelocityLimitCurve scan_feedrate(const curves::NurbsCurve& curve, const ScanLimits& limits);

// A curve that is continued at both ends along the circle of its curvature there, or straight. A
// tick may pass over an end, so that a part of its chord lies beyond; where the neighbour turns in
// another way, the junction bounds the feedrate.
class ContinuedCurve {
 public:
  // The curve has to outlive it.
  explicit ContinuedCurve(const curves::NurbsCurve& curve);

  [[nodiscard]] const curves::NurbsCurve& curve() const { return curve_; }
  // Any place: below 0 before the curve, above its length after it.
  [[nodiscard]] Eigen::Vector3d at(double s_mm) const;

 private:
  const curves::NurbsCurve& curve_;
  curves::PathDerivatives begin_;
  curves::PathDerivatives end_;
};

// The farthest of kChordPoints points of the tick, then of those half and a quarter of their
// distance beside it; and of those where the curve is sharpest, which may all lie between them.
double chord_error_mm(const ContinuedCurve& path, const curves::Stretch& tick);

}  // namespace kerf::lookahead
