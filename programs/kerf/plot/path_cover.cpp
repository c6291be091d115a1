#include "programs/kerf/plot/path_cover.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kerf::program {

namespace {

constexpr std::uint8_t kBlank = std::numeric_limits<std::uint8_t>::max();

std::size_t cells_in(double length_mm, double cell_mm) {
  return static_cast<std::size_t>(length_mm / cell_mm) + 1;
}

}  // namespace

PathCover::PathCover(const PaperBox& box, double cell_mm)
    : origin_(box.min),
      cell_mm_(cell_mm),
      columns_(cells_in(box.width_mm(), cell_mm)),
      rows_(cells_in(box.height_mm(), cell_mm)),
      levels_(columns_ * rows_, kBlank) {}

std::uint8_t& PathCover::at(double u_mm, double v_mm) {
  const auto column = static_cast<std::size_t>(std::max(u_mm - origin_.u_mm, 0.0) / cell_mm_);
  const auto row = static_cast<std::size_t>(std::max(v_mm - origin_.v_mm, 0.0) / cell_mm_);
  return levels_[std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1)];
}

bool PathCover::draw(const PaperPoint& from, const PaperPoint& to, std::size_t level) {
  const double du = to.u_mm - from.u_mm;
  const double dv = to.v_mm - from.v_mm;
  // A line that leads far out of the box is drawn coarsely.
  const double steps = std::min(std::ceil(std::max(std::abs(du), std::abs(dv)) / cell_mm_),
                                2.0 * static_cast<double>(columns_ + rows_));
  const auto lowest = static_cast<std::uint8_t>(level);
  bool shows = false;
  double step = 0.0;
  while (step <= steps) {
    const double share = steps > 0.0 ? step / steps : 0.0;
    std::uint8_t& cell = at(from.u_mm + share * du, from.v_mm + share * dv);
    shows = shows || lowest < cell;
    cell = std::min(cell, lowest);
    step += 1.0;
  }
  return shows;
}

}  // namespace kerf::program
