// One piece of the arc-length map: its geometry and the polynomial x(s). Look-ahead side only.
#pragma once

#include "curves/bezier_span.hpp"
#include "curves/nurbs_piece.hpp"

namespace kerf::curves {

// The piece from u_begin whose right half is given, without x(s) and its place along the curve.
NurbsPiece unmapped_piece(const BezierSpan& right_half, Wide u_begin);

// Fits x(s) to the piece and returns its length in mm; negative: it has to be halved first.
double fit_length_map(NurbsPiece& piece);

}  // namespace kerf::curves
