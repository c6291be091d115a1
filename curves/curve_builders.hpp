// Builders of curves: arcs from what programs say, lines from a NURBS on a line, blends of corners.
#pragma once

#include <optional>
#include <variant>

#include <tl/expected.hpp>

#include "curves/arc.hpp"
#include "curves/line.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

// Radii that agree make an exact Arc. Where they differ, the centre moves along the chord to the
// nearest point that is equally far from both ends, if the path then stays as close to the written
// one as the radii differ: if it turns by half a circle at the most, or the move is no larger than
// that. Else (nearly full circles whose ends do not quite meet) the radius changes evenly with the
// angle, as polynomials of degree 9 within 1e-12 mm of that spiral for radii up to 1e4 mm.
// The parser decides how much the radii may differ. Errors: as Arc::make, and a spiral
// of more than 1000 turns.
tl::expected<std::variant<Arc, NurbsCurve>, CurveError> make_arc(const ArcShape& shape);

// The largest distance of a line from the curve that it stands for.
inline constexpr double kStraight_mm = 5e-10;

// The line from the curve's begin to its end where no point of the curve lies farther beside it
// than kStraight_mm and none is passed twice by more. On such a curve the derivatives by arc length
// are rounding: |q''| of what is 1e-10 mm beside a line may be anything. Nothing where it turns.
std::optional<Line> straight(const NurbsCurve& curve);

struct CornerLines {
  Position corner_mm{};
  Position direction_in{};  // unit vectors, not opposite to each other
  Position direction_out{};
  double way_mm = 0.0;  // length from the corner to either end, > 0
};

// r(w) = corner - way (1 - w)^3 in + way w^3 out; its u is w, in [0, 1]. The same curve as
// NurbsCurve::make() has of its control points, mapped at a tenth of the cost. Nothing: the lines
// turn back so nearly that it cannot be resolved.
std::optional<NurbsCurve> corner_cubic(const CornerLines& lines);

}  // namespace kerf::curves
