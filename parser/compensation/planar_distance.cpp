// Distances between curves in the plane.
//
// The nearest points of two curves are a crossing, or an end of one and the point of the other
// nearest to it, or a pair of points with a common normal: for a line and an arc that normal goes
// through the arc's centre, for two arcs through both. All of them are tried. An arc with two radii
// is taken to have the mean of both.
#include <algorithm>
#include <array>
#include <limits>

#include "parser/compensation/planar.hpp"

namespace kerf::parser::planar {

namespace {

double radius_mm(const ContourElement& arc) {
  return (arc.start_radius_mm() + arc.end_radius_mm()) / 2;
}

bool holds_angle(const ContourElement& arc, Vec from_centre) {
  constexpr double kNoise_rad = 1e-12;
  const double turn =
      std::fabs(turn_rad(arc.start_mm - arc.centre_mm, from_centre, arc.sweep_rad < 0.0));
  return turn <= std::fabs(arc.sweep_rad) + kNoise_rad || turn > kTurn_rad - kNoise_rad;
}

bool holds_place(const ContourElement& line, Vec point) {
  const Vec along = line.end_mm - line.start_mm;
  const double at = dot(point - line.start_mm, along);
  return at >= 0.0 && at <= dot(along, along);
}

bool holds(const ContourElement& curve, Vec point) {
  return curve.is_arc() ? holds_angle(curve, point - curve.centre_mm) : holds_place(curve, point);
}

double from_point_mm(Vec point, const ContourElement& curve) {
  const double to_ends = std::min(length(point - curve.start_mm), length(point - curve.end_mm));
  if (!holds(curve, point)) {
    return to_ends;
  }
  if (curve.is_arc()) {
    return std::min(to_ends, std::fabs(length(point - curve.centre_mm) - radius_mm(curve)));
  }
  const Vec along = curve.end_mm - curve.start_mm;
  const double size = length(along);
  return size > 0.0 ? std::min(to_ends, std::fabs(cross(along, point - curve.start_mm)) / size)
                    : to_ends;
}

// Of a line and an arc by their common normal, and 0 if they cross.
double line_to_arc_mm(const ContourElement& line, const ContourElement& arc) {
  double best = std::numeric_limits<double>::infinity();
  const Vec along = line.end_mm - line.start_mm;
  const double square = dot(along, along);
  if (square == 0.0) {
    return best;
  }
  const Vec foot = line.start_mm + (dot(arc.centre_mm - line.start_mm, along) / square) * along;
  const Vec normal = foot - arc.centre_mm;
  const double away = length(normal);
  const double radius = radius_mm(arc);
  if (away >= radius) {
    return holds_place(line, foot) && holds_angle(arc, normal) ? away - radius : best;
  }
  const double half = std::sqrt((radius - away) * (radius + away) / square);
  for (const Vec point : {foot - half * along, foot + half * along}) {
    if (holds_place(line, point) && holds_angle(arc, point - arc.centre_mm)) {
      return 0.0;
    }
  }
  if (away > 0.0 && holds_place(line, foot) && holds_angle(arc, normal)) {
    best = radius - away;
  }
  return best;
}

bool arcs_cross(const ContourElement& a, const ContourElement& b, Vec between) {
  const double apart = length(between);
  const double ra = radius_mm(a);
  const double rb = radius_mm(b);
  const double foot = (apart * apart + (ra - rb) * (ra + rb)) / (2 * apart);
  const double square = (ra - foot) * (ra + foot);
  if (square < 0.0) {
    return false;
  }
  const Vec along = (1.0 / apart) * between;
  const std::array sides{std::sqrt(square), -std::sqrt(square)};
  return std::ranges::any_of(sides, [&](double side) {
    const Vec from_a = foot * along + side * left_of(along);
    return holds_angle(a, from_a) && holds_angle(b, from_a - between);
  });
}

double arc_to_arc_mm(const ContourElement& a, const ContourElement& b) {
  double best = std::numeric_limits<double>::infinity();
  const Vec between = b.centre_mm - a.centre_mm;
  const double apart = length(between);
  if (apart < 1e-12) {
    return best;  // concentric: an end is as near as any other point
  }
  if (arcs_cross(a, b, between)) {
    return 0.0;
  }
  const Vec along = (1.0 / apart) * between;
  for (const double side_a : {1.0, -1.0}) {
    for (const double side_b : {1.0, -1.0}) {
      const Vec from_a = (side_a * radius_mm(a)) * along;
      const Vec from_b = (side_b * radius_mm(b)) * along;
      if (holds_angle(a, from_a) && holds_angle(b, from_b)) {
        best = std::min(best, length(between + from_b - from_a));
      }
    }
  }
  return best;
}

bool lines_cross(const ContourElement& a, const ContourElement& b) {
  const Vec along_a = a.end_mm - a.start_mm;
  const Vec along_b = b.end_mm - b.start_mm;
  const auto parted = [](double first, double second) { return first * second < 0.0; };
  return parted(cross(along_a, b.start_mm - a.start_mm), cross(along_a, b.end_mm - a.start_mm)) &&
         parted(cross(along_b, a.start_mm - b.start_mm), cross(along_b, a.end_mm - b.start_mm));
}

double inside_mm(const ContourElement& a, const ContourElement& b) {
  if (a.is_arc()) {
    return b.is_arc() ? arc_to_arc_mm(a, b) : line_to_arc_mm(b, a);
  }
  if (b.is_arc()) {
    return line_to_arc_mm(a, b);
  }
  return lines_cross(a, b) ? 0.0 : std::numeric_limits<double>::infinity();
}

struct Box {
  Vec low;
  Vec high;
};
Box box_of(const ContourElement& curve) {
  if (curve.is_arc()) {
    const double radius = std::max(curve.start_radius_mm(), curve.end_radius_mm());
    return {curve.centre_mm - Vec{radius, radius}, curve.centre_mm + Vec{radius, radius}};
  }
  return {{std::min(curve.start_mm.x, curve.end_mm.x), std::min(curve.start_mm.y, curve.end_mm.y)},
          {std::max(curve.start_mm.x, curve.end_mm.x), std::max(curve.start_mm.y, curve.end_mm.y)}};
}

}  // namespace

double distance_mm(const ContourElement& a, const ContourElement& b) {
  return std::min({from_point_mm(a.start_mm, b), from_point_mm(a.end_mm, b),
                   from_point_mm(b.start_mm, a), from_point_mm(b.end_mm, a), inside_mm(a, b)});
}

bool far_apart(const ContourElement& a, const ContourElement& b, double distance_mm) {
  const Box box_a = box_of(a);
  const Box box_b = box_of(b);
  return box_a.low.x - box_b.high.x > distance_mm || box_b.low.x - box_a.high.x > distance_mm ||
         box_a.low.y - box_b.high.y > distance_mm || box_b.low.y - box_a.high.y > distance_mm;
}

}  // namespace kerf::parser::planar
