// Space onto paper.
#pragma once

#include <algorithm>

#include "curves/position.hpp"

namespace kerf::program {

// Millimetres on paper, v upwards.
struct PaperPoint {
  double u_mm = 0.0;
  double v_mm = 0.0;

  friend bool operator==(const PaperPoint&, const PaperPoint&) = default;
};

enum class View : unsigned char { top, isometric };

struct PaperBox {
  PaperPoint min{};
  PaperPoint max{};
  [[nodiscard]] double width_mm() const noexcept { return max.u_mm - min.u_mm; }
  [[nodiscard]] double height_mm() const noexcept { return max.v_mm - min.v_mm; }
};

// From above where z hardly matters beside x and y, else isometric: x to the lower right, y to the
// upper right, z upwards.
inline View view_of(const curves::Extents& extents) noexcept {
  const auto size = [&](std::size_t k) { return extents.max_mm[k] - extents.min_mm[k]; };
  constexpr double kFlat = 0.002;
  return size(2) <= kFlat * std::max(size(0), size(1)) ? View::top : View::isometric;
}

inline PaperPoint project(View view, const curves::Position& p) noexcept {
  if (view == View::top) {
    return {.u_mm = p[0], .v_mm = p[1]};
  }
  constexpr double kCos30 = 0.86602540378443864676;
  return {.u_mm = (p[0] + p[1]) * kCos30, .v_mm = (p[1] - p[0]) * 0.5 + p[2]};
}

// The smallest upright box around the projected extents.
inline PaperBox box_of(View view, const curves::Extents& extents) noexcept {
  PaperBox box{.min = project(view, extents.min_mm), .max = project(view, extents.min_mm)};
  for (unsigned corner = 1; corner < 8; ++corner) {
    curves::Position p = extents.min_mm;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = (corner >> k & 1U) != 0 ? extents.max_mm[k] : p[k];
    }
    const PaperPoint q = project(view, p);
    box.min = {.u_mm = std::min(box.min.u_mm, q.u_mm), .v_mm = std::min(box.min.v_mm, q.v_mm)};
    box.max = {.u_mm = std::max(box.max.u_mm, q.u_mm), .v_mm = std::max(box.max.v_mm, q.v_mm)};
  }
  return box;
}

}  // namespace kerf::program
