// The axes of a plane and the measures of an arc in it.
#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>

#include "parser/moves/move.hpp"

namespace kerf::parser {

// Indices into a Point of the plane's axes in right-handed order.
struct PlaneAxes {
  std::size_t first;
  std::size_t second;
  std::size_t normal;
};
constexpr PlaneAxes axes_of(Plane plane) {
  switch (plane) {
    case Plane::zx:
      return {2, 0, 1};
    case Plane::yz:
      return {1, 2, 0};
    default:
      return {0, 1, 2};
  }
}
// A point as the plane's axes see it.
struct InPlane {
  double first;
  double second;
};
inline InPlane in_plane(const Point& point, PlaneAxes axes) {
  return {point[axes.first], point[axes.second]};
}
inline double distance(InPlane a, InPlane b) {
  return std::hypot(a.first - b.first, a.second - b.second);
}

constexpr char axis_letter(std::size_t axis) {
  return static_cast<char>('X' + axis);
}
constexpr char centre_letter(std::size_t axis) {
  return static_cast<char>('I' + axis);
}

std::string_view plane_name(Plane plane);  // XY, XZ, YZ

// The two letters of the axes of a plane.
constexpr Letters plane_letters(Plane plane) {
  return letter_bit(axis_letter(axes_of(plane).first)) |
         letter_bit(axis_letter(axes_of(plane).second));
}

// Along the arc or helix, with the mean of both radii where they differ.
double arc_length_mm(const ArcMove& arc, const Point& start_mm);
// Of those at the start and at the end.
double larger_radius_mm(const ArcMove& arc, const Point& start_mm);

}  // namespace kerf::parser
