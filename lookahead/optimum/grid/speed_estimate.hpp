// A first estimate of the optimum: as fast as velocities, accelerations and jerks allow.
#pragma once

#include <span>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"

namespace kerf::lookahead {

// The limits along the path, from the path's own and those of the axes, for a change of feedrate on
// a straight path in this direction.
double tangential_acceleration_mm_s2(const Cell& cell, const curves::PathDerivatives& end,
                                     const PlanLimits& limits);
double tangential_jerk_mm_s3(const Cell& cell, const curves::PathDerivatives& end,
                             const PlanLimits& limits);

// The feedrate at which the path's curvature alone uses up a limit, and the cap.
double curvature_feedrate_mm_s(const Cell& cell, const PathSample& end, const PlanLimits& limits);

// The feedrate of an end of a row of cells; infinity: as fast as it goes.
struct EndFeeds {
  double v_begin_mm_s = kUnbounded;
  double v_end_mm_s = kUnbounded;
};

// Feedrates at the ends of the cells, one more than there are cells: the caps bent below what
// tangential acceleration and jerk reach, forwards and backwards. Jerk counts where acceleration
// builds up from the cap's, not where it has to end again. No bound of the optimum, in either
// direction: the share of the axes' acceleration that curvature takes is left out.
std::vector<double> estimate_feeds(std::span<const Cell> cells, const EndFeeds& ends,
                                   const PlanLimits& limits);

// The distance in mm over which the share that curvature takes of the axes' limits changes by no
// more than one cell allows, at the feedrate of the motion and up to its acceleration along the
// path. The length of the cell does not matter.
double change_mm(const Cell& cell, const StartState& motion, const PlanLimits& limits);

// For each cell the time in s for which the estimated feedrate rises, falls or stays level around
// it. feeds: at the ends of the cells, one more than there are.
std::vector<double> legs_of(const std::vector<Cell>& cells, const std::vector<double>& feeds_mm_s);

// The time of a cell on a leg, where the jerk takes jerk_time_s to build the acceleration up. The
// smaller the share of such ramps is, the less time is lost by resolving them coarsely.
double cell_time_s(double leg_s, double jerk_time_s);

}  // namespace kerf::lookahead
