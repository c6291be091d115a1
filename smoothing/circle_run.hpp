// A run of short lines that stands for an arc.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "curves/arc.hpp"
#include "smoothing/polyline.hpp"

namespace kerf::smoothing {

struct CircleRun {
  curves::Arc arc;
  std::vector<double> s_mm;   // where on the arc each line begins
  double deviation_mm = 0.0;  // of the arc from vertices and lines
};

// The arc from the first vertex to `last` in one of the planes of the axes, a whole circle if it is
// closed. Nothing where there are few lines, where a vertex is farther from the circle than the
// last decimals of a program explain, or a line farther than the tolerance.
std::optional<CircleRun> circle_of(const Polyline& run, std::size_t last, double tolerance_mm);

}  // namespace kerf::smoothing
