// Curves whose curvature jumps: splines of degree 2, double knots.
//
// Idea. A jump of the curvature by k is a jump of the acceleration by k v^2, for which the jerk of
// a tick has to suffice: so it is passed slowly, however smooth the rest of the curve is. Under G64
// it becomes a ramp, within P. Where jumps are far apart, the curve is cut at them and a blend goes
// into each junction; what lies between stays as it is programmed. Where they are so near that
// blends would take all of the curve, its points go the way of runs of short lines: one spline,
// four times continuously differentiable, within the tolerance of all of it.
//
// Weakness. One near pair of jumps makes a spline of all of the curve.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/nurbs_curve.hpp"
#include "smoothing/blender.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// Where the curvature jumps, in mm along the curve, between its begin and its end.
std::vector<double> curvature_jumps(const curves::NurbsCurve& curve);

// The blends that the jumps want at this feedrate meet.
bool blends_meet(const curves::NurbsCurve& curve, const std::vector<double>& jumps_mm,
                 double feedrate_mm_s, const BlendSettings& settings);

// The segment's curve, cut at these places. Precondition: it is a NURBS, and they lie within it in
// order.
void append_cut(const PathSegment& segment, const std::vector<double>& at_mm,
                std::vector<PathSegment>& out);

// Points of a curve as a run of short lines.
struct SampledCurve {
  std::vector<curves::Position> points_mm;  // after its begin; the last is its end
  double beside_mm = 0.0;                   // the curve's distance from the lines, at the most
};

// Lines at most about tolerance_mm / 20 from the curve; none where that takes too many.
SampledCurve sampled(const curves::NurbsCurve& curve, double tolerance_mm);

}  // namespace kerf::smoothing
