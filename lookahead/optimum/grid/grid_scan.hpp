// The lengths that the cells of the time optimum may have along a block.
#pragma once

#include <vector>

#include "lookahead/optimum/grid/cell_stops.hpp"
#include "lookahead/optimum/grid/speed_estimate.hpp"

namespace kerf::lookahead {

// Three things bound the length of a cell, each a function of the place, linear between places.
//
//   motion   the estimated motion must be resolved: where the feedrate rises or falls, a share of
//            the time in which the jerk builds the acceleration up (the time lost grows with about
//            the power 3/2 of that share), and on a bend so little that what curvature takes of the
//            limits changes by a part of them only; one tick at the least, eight at the most, so
//            that the check between the ends of a cell looks at nearly every tick
//   quiet    where only the limit of the feedrate binds, the cells grow with the distance from
//            places where something else does, as long as that limit is nearly constant between
//            their ends
//   feature  features of the path itself, even if far shorter than a tick: radius, pieces
class GridScan {
 public:
  // ends: the feedrates allowed at the block's ends; stops: where cells end anyway.
  GridScan(const BlockPath& path, const EndFeeds& ends, const std::vector<CellStop>& stops,
           const PlanLimits& limits);

  // How long a cell at this place of the block may be.
  [[nodiscard]] double cell_mm(double s_mm) const;
  // No cell is shorter.
  [[nodiscard]] double min_mm() const;
  [[nodiscard]] double length_mm() const { return places_mm_.back(); }

 private:
  void find_motion(const std::vector<Cell>& cells, const PlanLimits& limits);
  void find_quiet(const BlockPath& path, const std::vector<Cell>& cells, const EndFeeds& ends,
                  const PlanLimits& limits);

  std::vector<double> places_mm_;
  std::vector<double> feeds_mm_s_;
  std::vector<double> motion_mm_;
  std::vector<double> quiet_mm_;  // the distance from places that are not quiet
  std::vector<double> cap_mm_;    // in which the bound of the feedrate changes by a part of it
  std::vector<double> feature_mm_;
  double least_mm_ = 0.0;  // of what the motion asks for; see kMostWhereSlow
};

// The cell of a block on a stretch of it. before: the cell that ends where it begins, if nothing
// jumps there; else nullptr.
Cell cell_between(const BlockPath& path, const curves::Stretch& stretch, const Cell* before);

}  // namespace kerf::lookahead
