// The cells of a way to rest, as the search for it divides them.
#pragma once

#include <cstdint>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"

namespace kerf::lookahead {

struct CellsToRest {
  std::vector<Cell> cells{};
  bool is_end = false;  // that is the end of what is known: a rest at the distance is there
};
// The first of the cells ahead, to a rest at the distance.
CellsToRest cells_to(double distance_mm, std::vector<Cell> cells, const PathAt& path);

// How finely the way is divided: a try over a fine one takes longer.
enum class StopGrid : std::uint8_t { coarse, fine };

struct RestGrid {
  double distance_mm = 0.0;  // the length of all cells
  StopGrid grid = StopGrid::coarse;
};
// There is a cell. The first ones, and those beside the rest, are shorter than the others.
void divide_for_rest(const RestGrid& of, const PathAt& path, const PlanLimits& limits,
                     std::vector<Cell>& cells);

}  // namespace kerf::lookahead
