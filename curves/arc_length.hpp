// The arc-length map: a smooth row of rational Bezier spans cut into pieces that know u(s).
// Look-ahead side only.
#pragma once

#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "curves/bezier_span.hpp"
#include "curves/curve_error.hpp"
#include "curves/nurbs_piece.hpp"

namespace kerf::curves {

// Largest error along the path of a piece's x(s), for pieces up to 1e3 mm long: a point asked for
// at s lies at s +- this from the begin of its piece. Over a whole curve the rounding of s itself
// and of the sum of the pieces' lengths are added; together they stay below kTotalTolerance_mm for
// curves up to 1e3 mm.
inline constexpr double kArcLengthTolerance_mm = 1e-11;
inline constexpr double kTotalTolerance_mm = 1e-9;

// Pieces in order, by smooth curve: normally one, more where the curve turns a corner or back on
// itself between two pieces, none if it is no longer than 1e-11 mm. Each span begins where the one
// before it ends, in the same direction; the last piece ends in end_mm exactly. Error: a span that
// no number of pieces resolves (with its u and place).
tl::expected<std::vector<std::vector<NurbsPiece>>, CurveError> map_arc_length(
    std::span<const BezierSpan> spans, const Position& end_mm);

}  // namespace kerf::curves
