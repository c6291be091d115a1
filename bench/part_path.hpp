// The path that a program writes, element by element, and how far a point is from it.
#pragma once

#include <array>
#include <cstdint>

#include "parser/moves/move.hpp"

namespace kerf::bench {

using parser::Point;

inline constexpr double kFullTurn_rad = 6.283185307179586;

// A line, or an arc in XY, which is a helix where Z moves.
struct PathElement {
  Point from_mm{};
  Point to_mm{};
  std::uint32_t line = 0;  // of the program
  double radius_mm = 0.0;  // 0: a line
  std::array<double, 2> centre_mm{};
  double begin_rad = 0.0;
  double sweep_rad = 0.0;  // > 0: counterclockwise

  [[nodiscard]] double length_mm() const;
  [[nodiscard]] Point at(double share) const;
};

struct Nearest {
  double distance_mm = 0.0;
  double share = 0.0;  // of the element's length, where it is
};

// Of a helix the place at the point's own angle: a little farther than the nearest.
Nearest nearest(const PathElement& element, const Point& point_mm);

double distance_mm(const Point& a, const Point& b);

}  // namespace kerf::bench
