// Whether a plan keeps its limits between the places at which the solver looked.
#pragma once

#include <vector>

#include "lookahead/optimum/solver/barrier_objective.hpp"

namespace kerf::lookahead {

// The largest figures over their limits; 1 is the limit.
struct Excess {
  double feedrate = 0.0;
  double acceleration = 0.0;
  double jerk = 0.0;

  [[nodiscard]] double largest() const noexcept;
};

// Of one cell of the spline, at places within it; shares are left out: what counts is the
// limit, or what a junction leaves of it.
Excess excess_of(const Cell& cell, const SquaredFeed& begin, const PathAt& path,
                 const PlanLimits& limits);

// A launch or landing of constant jerk that meets the spline with v.
Excess excess_of_rest(const Cell& cell, double v_mm_s, bool launch, const PathAt& path,
                      const PlanLimits& limits);

}  // namespace kerf::lookahead
