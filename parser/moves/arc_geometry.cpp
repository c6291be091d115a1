#include "parser/moves/arc_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kerf::parser {

namespace {

constexpr double kPi = 3.14159265358979323846;

}  // namespace

std::string_view plane_name(Plane plane) {
  constexpr std::array<std::string_view, 3> kNames{"XY", "XZ", "YZ"};
  return kNames[static_cast<std::size_t>(plane)];
}

double arc_length_mm(const ArcMove& arc, const Point& start_mm) {
  const PlaneAxes axes = axes_of(arc.plane);
  const InPlane centre = in_plane(arc.centre_mm, axes);
  const InPlane start = in_plane(start_mm, axes);
  const InPlane end = in_plane(arc.end_mm, axes);
  double angle = std::atan2(end.second - centre.second, end.first - centre.first) -
                 std::atan2(start.second - centre.second, start.first - centre.first);
  angle = arc.clockwise ? -angle : angle;
  const bool closed = start.first == end.first && start.second == end.second;
  angle = closed ? 2 * kPi : angle <= 0.0 ? angle + 2 * kPi : angle;
  angle += 2 * kPi * (arc.turns - 1);
  const double radius = (distance(centre, start) + distance(centre, end)) / 2;
  return std::hypot(radius * angle, arc.end_mm[axes.normal] - start_mm[axes.normal]);
}

double larger_radius_mm(const ArcMove& arc, const Point& start_mm) {
  const PlaneAxes axes = axes_of(arc.plane);
  const InPlane centre = in_plane(arc.centre_mm, axes);
  return std::max(distance(centre, in_plane(start_mm, axes)),
                  distance(centre, in_plane(arc.end_mm, axes)));
}

}  // namespace kerf::parser
