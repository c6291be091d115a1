// A bound of the way to rest, by steps in time: what the search's ways are held against.
#pragma once

#include <kerf/machine.hpp>

#include "tests/kernel/planned_path.hpp"

namespace kerf::bench {

struct PathState {
  double s_mm = 0.0;  // path length
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
};

// No way to rest along the path is shorter, but for the size of a step. At each step the lowest
// jerk that all axes bear at the place, down to the lowest acceleration that they bear; from where
// the highest jerk brings the motion to rest, that. Optimistic: jumps of direction and curvature
// cost nothing, and where no jerk keeps all limits the path's own counts.
double shortest_stop_mm(const test::PlannedPath& path, const PathState& from,
                        const MachineLimits& limits);

}  // namespace kerf::bench
