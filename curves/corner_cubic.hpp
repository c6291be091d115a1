// The cubic Bezier curve whose two inner points lie in the corner between two lines and whose ends
// lie equally far from it on them. Look-ahead side only.
#pragma once

#include <optional>

#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

struct CornerLines {
  Position corner_mm{};
  Position direction_in{};  // unit vectors, not opposite to each other
  Position direction_out{};
  double way_mm = 0.0;  // from the corner to either end, > 0
};

// r(w) = corner - way (1 - w)^3 in + way w^3 out; its u is w, in [0, 1]. The same curve as
// NurbsCurve::make() has of its control points, mapped at a tenth of the cost. Nothing: the lines
// turn back so nearly that it cannot be resolved.
std::optional<NurbsCurve> corner_cubic(const CornerLines& lines);

}  // namespace kerf::curves
