// Which parts of a drawn path can be seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "programs/kerf/plot/projection.hpp"

namespace kerf::program {

// Squares of paper, each with the lowest level drawn on it: where lines cross, the lower is on top.
class PathCover {
 public:
  // cell_mm > 0
  PathCover(const PaperBox& box, double cell_mm);

  // Draws a straight line. False: it is hidden, since all of its cells have a level as low.
  bool draw(const PaperPoint& from, const PaperPoint& to, std::size_t level);

 private:
  [[nodiscard]] std::uint8_t& at(double u_mm, double v_mm);

  PaperPoint origin_;
  double cell_mm_;
  std::size_t columns_;
  std::size_t rows_;
  std::vector<std::uint8_t> levels_;
};

}  // namespace kerf::program
