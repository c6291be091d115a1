// The feedrate that a curve allows at each of its points, as samples over arc length.
#pragma once

#include <cstddef>
#include <vector>

namespace kerf::lookahead {

struct FeedSample {
  double u = 0.0;
  double s_mm = 0.0;
  double v_mm_s = 0.0;
};

// Piecewise linear between samples; s ascends.
using Ceiling = std::vector<FeedSample>;

}  // namespace kerf::lookahead
