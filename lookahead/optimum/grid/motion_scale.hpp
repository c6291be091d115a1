// In which time and on which length the estimated motion changes.
#pragma once

#include <vector>

#include "lookahead/optimum/grid/cell.hpp"

namespace kerf::lookahead {

// How far until what curvature takes of the axes' limits has changed by a part that a cell can
// bear, at this feedrate and up to this acceleration along the path, mm. cell: far shorter or not.
double change_mm(const Cell& cell, double v_mm_s, double acceleration_mm_s2,
                 const PlanLimits& limits);

// Of each cell, how long the estimated feedrate rises or falls around it, or does neither, s.
// feeds: at the ends of the cells, one more than there are.
std::vector<double> legs_of(const std::vector<Cell>& cells, const std::vector<double>& feeds_mm_s);

// The time of a cell on a leg, where the jerk takes jerk_time_s to build the acceleration up. The
// fewer of its time are such ramps, the less of it is lost where they are resolved coarsely.
double cell_time_s(double leg_s, double jerk_time_s);

}  // namespace kerf::lookahead
