// The search for the time-optimal feedrate over one sequence of cells.
#pragma once

#include <optional>
#include <vector>

#include "lookahead/optimum/solver/barrier_objective.hpp"

namespace kerf::lookahead {

// Coefficients of the spline of v^2, and what they cost.
struct OptimalFeed {
  std::vector<double> coefficients;
  int newton_steps = 0;
  double mean_s = 0.0;      // the time over the coefficients, by which barriers are weighed
  double last_share = 0.0;  // of the time, in all barriers of the last stage
};

// Where the search begins: 0.3 of what velocities, accelerations and jerks allow. Positive and
// finite.
std::vector<double> first_feed(const CellSequence& sequence, const PlanLimits& limits);

// Minimises the time of a sequence of cells under all its limits: v, a and jerk, along the path and
// on each axis, at both ends of every cell.
//
// The idea. Over arc length, with b = v^2, time is a convex function and every limit but jerk is
// linear [Verscheure]. Jerk is sqrt(b) times a linear form; taken as linear about the present b it
// makes each step convex. Instead of solving each such convex problem to its end, the form is
// renewed in every Newton step of one interior-point search: barriers in front of all limits,
// softened so that the search may begin beyond them, and sharpened in small stages. b is a spline
// with three coefficients a cell, so a step costs O(n).
//
//   begin: 0.3 of the v^2 that acceleration and jerk allow  ->  weight 1e-1 of the time in all
//   barriers some 3 Newton steps each                                ->  3e-2, 1e-2, ... 1e-4,
//   and on until that is less than a quarter of a tick
//
// Some 20 steps suffice on all curves tried, whatever their length. The answer is a local optimum:
// the problem is not convex in jerk, and no bound of its distance to the true one is known; on the
// curves for which reference times exist it meets them.
//
// Where cells know an earlier plan that was faster than that guess, it begins from there.
// Precondition: at least two cells of spline.
OptimalFeed find_optimal_feed(const CellSequence& sequence, const PlanLimits& limits);

// Goes on from an answer after limits have been tightened a little on cells of the spline; the
// feedrate beyond the range stays. Returns the Newton steps, which feed does not count.
// Precondition: the range has at least three cells, or all.
int refine_optimal_feed(const CellSequence& sequence, const PlanLimits& limits,
                        const SplineRange& range, OptimalFeed& feed);

}  // namespace kerf::lookahead
