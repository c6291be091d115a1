// Arcs as programs write them: rounded centres and ends whose radii differ a little.
#pragma once

#include <variant>

#include <tl/expected.hpp>

#include "curves/arc.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

// Radii that agree make an exact Arc. Where they differ, the centre moves to the nearest point that
// is equally far from both ends, if that is no farther than the radii differ; else (nearly full
// circles whose ends do not quite meet) the radius changes evenly along the arc.
tl::expected<std::variant<Arc, NurbsCurve>, CurveError> make_arc(const ArcShape& shape);

}  // namespace kerf::curves
