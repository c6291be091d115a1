// Where the program's lines begin on a segment, once it has been cut or blended.
#pragma once

#include <vector>

#include "smoothing/blend.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::smoothing {

// The segment's marks once its first by_mm are gone.
void shift_marks(PathSegment& segment, double by_mm);

// The lines that a blend runs along: up to the corner those of the segment before, then those of
// the segment after. way_mm: what the blend takes of each.
std::vector<LineMark> marks_along(const Blend& blend, double way_mm, const PathSegment& before,
                                  const PathSegment& after);

}  // namespace kerf::smoothing
