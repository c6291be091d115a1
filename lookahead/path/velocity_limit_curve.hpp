// The feedrate that a curve allows at each of its points, as samples over arc length.
#pragma once

#include <cstddef>
#include <vector>

#include "interp/constraint.hpp"

namespace kerf::lookahead {

struct FeedSample {
  double u = 0.0;
  double s_mm = 0.0;
  double v_mm_s = 0.0;
  interp::Constraint limit = interp::Constraint::chord_error;  // that v_mm_s comes from
};

// Piecewise linear between samples; s ascends.
using VelocityLimitCurve = std::vector<FeedSample>;

}  // namespace kerf::lookahead
