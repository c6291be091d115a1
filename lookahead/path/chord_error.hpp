// How far a curve is from the chord of a tick.
#pragma once

#include "curves/nurbs_curve.hpp"

namespace kerf::lookahead {

// A curve with what it meets taken to go on as it ends there: along a circle of its curvature, or
// straight. A tick may pass over an end, and its chord be over what lies behind; where that turns
// in another way, the junction bounds the feedrate.
class ContinuedCurve {
 public:
  // The curve has to outlive it.
  explicit ContinuedCurve(const curves::NurbsCurve& curve);

  [[nodiscard]] const curves::NurbsCurve& curve() const { return curve_; }
  // Any place: below 0 before the curve, above its length behind it.
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
