// The curves made from a run of short lines, as path segments with the feedrates and lines of the
// program.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "curves/arc.hpp"
#include "curves/curve.hpp"
#include "parser/moves/move.hpp"
#include "smoothing/path_segment.hpp"
#include "smoothing/polyline.hpp"

namespace kerf::smoothing {

// A curve in the place of the lines that end in the vertices first + 1 to last of a run.
struct MergedCurve {
  curves::Curve curve;
  std::size_t first = 0;
  std::size_t last = 0;
  std::vector<double> s_mm{};  // where on the curve each of these lines begins; the first at 0
  bool continues = false;      // the segment before
  double deviation_mm = 0.0;   // from the lines, at the most
};

// Appends it in one segment, or in one for each stretch of one feedrate. like: a move of the run.
void append_segments(const Polyline& run, const MergedCurve& merged, const parser::Move& like,
                     std::vector<PathSegment>& segments);

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
