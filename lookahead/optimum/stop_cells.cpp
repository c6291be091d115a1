#include "lookahead/optimum/stop_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lookahead/optimum/braking.hpp"
#include "lookahead/optimum/grid/grid.hpp"
#include "lookahead/optimum/grid/junction_share.hpp"

namespace kerf::lookahead {

namespace {

constexpr double kCellsOfWay = 40.0;
constexpr double kFineCellsOfWay = 64.0;
constexpr double kWorthDividing = 0.1;  // of the longest cell

void divide(std::vector<Cell>& cells, double longest_mm, const PathAt& path) {
  std::vector<Cell> divided;
  for (const Cell& cell : cells) {
    const double count = std::ceil(cell.length_mm / longest_mm);
    const std::vector<double> lengths(static_cast<std::size_t>(std::max(count, 1.0)),
                                      cell.length_mm / std::max(count, 1.0));
    const std::vector<Cell> parts = parts_of(cell, lengths, path);
    divided.insert(divided.end(), parts.begin(), parts.end());
  }
  cells = std::move(divided);
}

// A motion near a limit may bear the jerk that it has for less than a cell.
void divide_first(std::vector<Cell>& cells, double longest_mm, const PathAt& path) {
  const Cell first = cells.front();
  if (first.length_mm < kWorthDividing * longest_mm) {
    return;
  }
  const double quarter_mm = 0.25 * first.length_mm;
  const std::vector<Cell> parts = parts_of(first, {quarter_mm, quarter_mm, 2.0 * quarter_mm}, path);
  cells.erase(cells.begin());
  cells.insert(cells.begin(), parts.begin(), parts.end());
}

}  // namespace

CellsToRest cells_to(double distance_mm, std::vector<Cell> cells, const PathAt& path) {
  double way = 0.0;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double left = distance_mm - way;
    const Cell& cell = cells[i];
    if (cell.rest_after && left >= cell.length_mm - kAtBlockEnd_mm) {
      cells.resize(i + 1);
      return {.cells = std::move(cells), .is_end = true};
    }
    if (left < cell.length_mm - kAtBlockEnd_mm) {
      if (left > kAtBlockEnd_mm) {
        cells[i] = parts_of(cell, {left, cell.length_mm - left}, path).front();
      }
      cells.resize(left > kAtBlockEnd_mm ? i + 1 : i);
      return {.cells = std::move(cells), .is_end = false};
    }
    way += cell.length_mm;
  }
  return {.cells = std::move(cells), .is_end = true};
}

void divide_for_rest(const RestGrid& of, const PathAt& path, const PlanLimits& limits,
                     std::vector<Cell>& cells) {
  const double longest_mm =
      of.distance_mm / (of.grid == StopGrid::fine ? kFineCellsOfWay : kCellsOfWay);
  divide(cells, longest_mm, path);
  divide_first(cells, longest_mm, path);
  if (cells.back().ends_block) {
    relax_beside_rest(cells, BlockSide::end);
  }
  refine_to_rest(cells, RestAt::end, path, limits);
}

}  // namespace kerf::lookahead
