#include "bench/part_path.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::bench {

double distance_mm(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double PathElement::length_mm() const {
  return radius_mm > 0.0 ? std::hypot(radius_mm * sweep_rad, to_mm[2] - from_mm[2])
                         : distance_mm(from_mm, to_mm);
}

Point PathElement::at(double share) const {
  Point point;
  for (std::size_t k = 0; k < 3; ++k) {
    point[k] = from_mm[k] + share * (to_mm[k] - from_mm[k]);
  }
  if (radius_mm > 0.0) {
    const double angle = begin_rad + share * sweep_rad;
    point[0] = centre_mm[0] + radius_mm * std::cos(angle);
    point[1] = centre_mm[1] + radius_mm * std::sin(angle);
  }
  return point;
}

namespace {

double share_on_line(const PathElement& line, const Point& point_mm) {
  double along = 0.0;
  double squared = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double way = line.to_mm[k] - line.from_mm[k];
    along += (point_mm[k] - line.from_mm[k]) * way;
    squared += way * way;
  }
  return squared > 0.0 ? std::clamp(along / squared, 0.0, 1.0) : 0.0;
}

double share_on_arc(const PathElement& arc, const Point& point_mm) {
  const double angle =
      std::atan2(point_mm[1] - arc.centre_mm[1], point_mm[0] - arc.centre_mm[0]) - arc.begin_rad;
  const double turned = arc.sweep_rad > 0.0 ? angle : -angle;
  const double sweep = std::abs(arc.sweep_rad);
  const double within = turned - kFullTurn_rad * std::floor(turned / kFullTurn_rad);
  if (within <= sweep) {
    return within / sweep;
  }
  return within - sweep < kFullTurn_rad - within ? 1.0 : 0.0;
}

}  // namespace

Nearest nearest(const PathElement& element, const Point& point_mm) {
  const double share =
      element.radius_mm > 0.0 ? share_on_arc(element, point_mm) : share_on_line(element, point_mm);
  Nearest best{.distance_mm = distance_mm(point_mm, element.at(share)), .share = share};
  if (element.radius_mm > 0.0) {  // a full circle's ends are one place, but of a helix two
    for (const double end : {0.0, 1.0}) {
      const double distance = distance_mm(point_mm, element.at(end));
      if (distance < best.distance_mm) {
        best = {.distance_mm = distance, .share = end};
      }
    }
  }
  return best;
}

}  // namespace kerf::bench
