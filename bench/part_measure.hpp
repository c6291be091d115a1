// What ticks show of a run, from their positions alone.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/part_path.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::bench {

// One a period, from the start on.
struct Ticks {
  std::vector<Point> at_mm;
  std::vector<std::uint32_t> line;
};

struct OverLimit {
  double ratio = 0.0;
  std::string what;  // "y jerk"
};

// The largest first, second or third difference of an axis over its limit.
OverLimit largest_over_limit(const Ticks& ticks, const lookahead::PlanLimits& limits);

// Near by means along both: a tick is held against what is programmed a little before and after
// where the tick before it was, and a programmed point against the ticks that were found there.
struct Deviation {
  double of_ticks_mm = 0.0;  // of any tick from the programmed path near by
  // Of any programmed end point, and of points between them, from the way of the ticks near by: a
  // cubic through four of them, or the chord of two, whichever is nearer.
  double of_path_mm = 0.0;
  double of_line_mm = 0.0;  // of any tick from what its own line programs
};

Deviation deviation(const Ticks& ticks, const std::vector<PathElement>& path);

}  // namespace kerf::bench
