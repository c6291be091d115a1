// A NURBS as written, its check and its cutting into Bezier spans. Look-ahead side only.
#pragma once

#include <vector>

#include <tl/expected.hpp>

#include "curves/bezier_span.hpp"
#include "curves/curve_error.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

// Everything about the numbers that can be wrong before any geometry is computed.
tl::expected<void, CurveError> check(const NurbsData& data);

// The Bezier form of the span between knots[knot] and knots[knot + 1], which differ, by blossoming.
// Precondition: checked data.
BezierSpan bezier_span(const NurbsData& data, std::size_t knot);

// Indices k of the knots with knots[k] < knots[k + 1], in order. Precondition: checked data.
std::vector<std::size_t> span_knots(const NurbsData& data);

}  // namespace kerf::curves
