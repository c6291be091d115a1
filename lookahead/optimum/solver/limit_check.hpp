// Checks whether a plan keeps its limits between the places at which the solver evaluated them.
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

// For one cell of the spline, at places within it. Shares are left out: the limit counts, or the
// part of it that a junction leaves.
Excess excess_of(const Cell& cell, const SquaredFeed& begin, const PathAt& path,
                 const PlanLimits& limits);

// At one place of a cell, for a motion whose s counts from the cell's begin.
Excess excess_at(const profiles::PathMotion& motion, const Cell& cell, const PathAt& path,
                 const PlanLimits& limits);

// For a launch or landing of constant jerk that meets the spline with v.
Excess excess_of_rest(const Cell& cell, double v_mm_s, bool launch, const PathAt& path,
                      const PlanLimits& limits);

// Feedrate squared on a cell of the spline: at both ends, and the coefficient that bounds it
// between them.
struct CellFeed {
  SquaredFeed begin{};
  SquaredFeed end{};
  double coefficient = 0.0;
};

// The limit of which a little more would save the most time in this cell. At an optimum found with
// barriers in front of the limits, a barrier's force is the price of its limit: by how much the
// time falls when the limit rises. The force is 1 over the slack, so the limit with the least slack
// is the one to raise; both ends count, so that a limit that is only touched in passing does not
// count for the cell. Of limits that bind alike the path's is named. Cells that leave most of the
// limits to the jump beside them are limited by that junction.
//
// Weakness: where the motion only follows from its neighbours (one cell between two that are bound)
// no limit binds, and the nearest one is named.
Constraint tightest_constraint(const Cell& cell, const CellFeed& feed, const PlanLimits& limits);

// For a launch from rest or a landing that meets the spline with v_mm_s.
Constraint tightest_constraint_at_rest(const Cell& cell, double v_mm_s, bool launch,
                                       const PlanLimits& limits);

}  // namespace kerf::lookahead
