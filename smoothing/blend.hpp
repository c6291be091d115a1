// The curve that takes the place of a corner.
//
// Idea. Let the tool still brake along the curve into the corner while it already accelerates along
// the curve out of it: r(w) = A(L - d (1 - w)^3) + B(d w^3) - C for w in [0, 1], where A is the
// curve before with its length L, B the one after, C the corner and d the length that the blend
// takes of each. So do axes whose moves may overlap: with a corner between two axes each
// of them keeps the law of its jerk, s = J t^3 / 6, so a corner is passed in half the time in which
// the tool would stop in it, on a path that is as far from it as the tolerance allows. The added
// curve begins with its third power, so r has A's direction and curvature at its begin and B's at
// its end, whatever curves they are. Between two lines r is a cubic whose inner control points lie
// in the corner; of other curves the polynomial of degree 5 is taken that has r's first two
// derivatives at both ends, which is the same on lines. Between lines the corner is its farthest
// place, d |tB - tA| / 8 away.
//
// Weakness. It suits corners that are passed in less time than the acceleration takes to build up;
// with tolerances of some hundredths these are nearly all. A rounder curve would let wide
// corners pass a few per cent faster.
#pragma once

#include <optional>

#include "curves/curve.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::smoothing {

// Two curves that meet: the end of the first is the begin of the second.
struct Corner {
  const curves::Curve* before = nullptr;
  const curves::Curve* after = nullptr;
};

struct Blend {
  curves::NurbsCurve curve;
  double s_corner_mm = 0.0;  // on it, where it passes the corner
};

// The blend that takes way_mm of each curve. Precondition: 0 < way_mm <= either length. Nothing: it
// would have a cusp, or is too short to be a curve.
std::optional<Blend> make_blend(const Corner& corner, double way_mm);

// The figures of a corner by which its blend is sized.
struct CornerShape {
  double turn = 0.0;              // |tB - tA|: 2 sin of half the angle
  double curvature_per_mm = 0.0;  // the larger of both sides
  double bend_per_mm = 0.0;       // by how much the curvature jumps
};

CornerShape shape_of(const Corner& corner);
CornerShape shape_between(const curves::PathDerivatives& before,
                          const curves::PathDerivatives& after);

// Direction goes on, as good as: curvature alone jumps, or it turns the path more over the way than
// the corner does.
bool is_tangential(const Corner& corner, double way_mm);

// The largest distance between the blend and the parts of the curves that it replaces, in either
// direction. Its line is not set.
PathDeviation deviation_of(const Blend& blend, const Corner& corner, double way_mm);

}  // namespace kerf::smoothing
