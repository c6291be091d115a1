// Which lines of the program path parts belong to, once blends have cut them.
#pragma once

#include <vector>

#include "smoothing/blend.hpp"
#include "smoothing/path_part.hpp"

namespace kerf::smoothing {

// What the part's marks are once its first by_mm are gone.
void shift_marks(PathPart& part, double by_mm);

// The line that a place on the part belongs to.
LineMark mark_at(const PathPart& part, double s_mm);

// The lines that a blend runs along: up to the corner those of the part before, then those of the
// part after. way_mm: what the blend takes of each.
std::vector<LineMark> marks_along(const Blend& blend, double way_mm, const PathPart& before,
                                  const PathPart& after);

}  // namespace kerf::smoothing
