// Curves that are lines.
#pragma once

#include <optional>

#include "curves/line.hpp"
#include "curves/nurbs_curve.hpp"

namespace kerf::curves {

// What a line may miss of the curve that it stands for.
inline constexpr double kStraight_mm = 5e-10;

// The line from the curve's begin to its end where no point of the curve lies farther beside it
// than kStraight_mm and none is passed twice by more. On such a curve the derivatives by arc length
// are rounding: |q''| of what is 1e-10 mm beside a line may be anything. Nothing where it turns.
std::optional<Line> straight(const NurbsCurve& curve);

}  // namespace kerf::curves
