// The fastest motion over a curve that any jerk allows, found without planning it.
#pragma once

#include <vector>

#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::bench {

// At the ends of equal cells.
struct AnyJerkMotion {
  double cell_mm = 0.0;
  std::vector<double> v_squared;  // mm^2/s^2
  double time_s = 0.0;

  [[nodiscard]] double v_squared_at(double s_mm) const;
};

// From rest to rest within feedrate, velocity and acceleration, along the path and of X, Y and Z,
// and chord error, with any jerk: no motion that keeps its jerk as well takes less. In v^2 over s
// these limits are linear, so the optimum is exact but for the grid: back from the end the largest
// v^2 at each place from which the next one can be reached, then forward as steeply as that allows
// (TOPP-RA; Pham and Pham, A New Approach to Time-Optimal Path Parameterization Based on
// Reachability Analysis, 2018). Limits are looked at in the places of the grid alone, and chord
// error by the radius there.
AnyJerkMotion any_jerk_motion(const lookahead::Block& block, const lookahead::PlanLimits& limits);

}  // namespace kerf::bench
