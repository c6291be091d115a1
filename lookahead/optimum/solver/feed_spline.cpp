#include "lookahead/optimum/solver/feed_spline.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace kerf::lookahead {

std::vector<CellBasis> feed_basis(std::span<const double> lengths_mm) {
  assert(std::ranges::all_of(lengths_mm, [](double length_mm) { return length_mm > 0.0; }));
  std::vector<CellBasis> cells(lengths_mm.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double h = lengths_mm[i];
    const double before = h + (i > 0 ? lengths_mm[i - 1] : 0.0);
    const double after = h + (i + 1 < cells.size() ? lengths_mm[i + 1] : 0.0);
    Basis& begin = cells[i].begin;
    Basis& end = cells[i].end;
    begin.value = {h / before, 1.0 - h / before, 0.0};
    begin.slope = {-2.0 / before, 2.0 / before, 0.0};
    end.value = {0.0, 1.0 - h / after, h / after};
    end.slope = {0.0, -2.0 / after, 2.0 / after};
    Basis& middle = cells[i].middle;
    for (std::size_t k = 0; k < 3; ++k) {
      const double bend = (end.slope[k] - begin.slope[k]) / h;
      begin.bend[k] = middle.bend[k] = end.bend[k] = bend;
      middle.slope[k] = 0.5 * (begin.slope[k] + end.slope[k]);
      middle.value[k] = begin.value[k] + 0.5 * h * begin.slope[k] + 0.125 * h * h * bend;
    }
  }
  return cells;
}

}  // namespace kerf::lookahead
