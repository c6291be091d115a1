// The search for the time optimum, begun anew from another motion.
#pragma once

#include <cstddef>

#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::bench {

// How long a plan takes whose search begins where Kerf's does, and one whose search begins from the
// fastest motion with any jerk (acceleration_bound.hpp), over the same cells: a curve from rest to
// its end, or to the first rest within it. 0: that search did not end well.
struct TwoStarts {
  double own_s = 0.0;
  double any_jerk_s = 0.0;
};
TwoStarts two_starts(const lookahead::Block& block, const lookahead::PlanLimits& limits);

// Both of all shipped curves, each under 200 random settings of limits, or of every so many-th. 1
// where its own start is slower by more than a hundredth, or by more than 0.003 in the median, or
// where the search from it did not end well.
int starts(std::size_t every);

}  // namespace kerf::bench
