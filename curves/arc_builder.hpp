// Arcs as programs write them: rounded centres and ends whose radii differ a little.
#pragma once

#include <variant>

#include <tl/expected.hpp>

#include "curves/arc.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

// Radii that agree make an exact Arc. Where they differ, the centre moves along the chord to the
// nearest point that is equally far from both ends, if the path then stays as close to the written
// one as the radii differ: if it turns by half a circle at the most, or the move is no larger than
// that. Else (nearly full circles whose ends do not quite meet) the radius changes evenly with the
// angle, as polynomials of degree 9 within 1e-12 mm of that spiral for radii up to 1e4 mm.
// How much the radii may differ at all is for the parser to say. Errors: as Arc::make, and a spiral
// of more than 1000 turns.
tl::expected<std::variant<Arc, NurbsCurve>, CurveError> make_arc(const ArcShape& shape);

}  // namespace kerf::curves
