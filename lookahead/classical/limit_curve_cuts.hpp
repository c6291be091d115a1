// Where the limit curve of a curve is cut into segments.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/classical/slope.hpp"
#include "lookahead/path/velocity_limit_curve.hpp"

namespace kerf::lookahead {

// Of samples, both included.
struct SampleRange {
  std::size_t first = 0;
  std::size_t last = 0;
};

// The samples from the range's begin up to the highest, and from its end down to there, each with
// the distance from where it begins.
struct Hill {
  std::vector<Slope::Sample> rise;
  std::vector<Slope::Sample> fall;
};

Hill hill_of(const VelocityLimitCurve& limit_curve, const SampleRange& range);

struct Cutting {
  double noise = 0.0;  // dips and humps of less than this share of the feedrate are none
  double period_s = 0.0;
  profiles::RampLimits ramp{};  // no ramp is steeper
};

struct CutLimitCurve {
  VelocityLimitCurve limit_curve;
  std::vector<std::size_t> cuts;  // samples, ascending; the last one's is the end
};

// Cut at its valleys and where a ramp from one would crawl (ramp_cuts.hpp). The limit curve has
// more samples then where feedrates of neighbours are far apart, and between valleys within a
// tick's way, which are one, the feedrate of the lowest. Precondition: two samples at least.
CutLimitCurve cut(const VelocityLimitCurve& scanned, const Cutting& how);

}  // namespace kerf::lookahead
