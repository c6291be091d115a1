#include "parser/compensation/planar.hpp"

#include <algorithm>

namespace kerf::parser::planar {

namespace {

// Angles this close to a whole turn are a point just outside the arc, not one nearly round it.
constexpr double kAngleNoise_rad = 1e-7;

bool clockwise(const ContourElement& curve) {
  return curve.sweep_rad < 0.0;
}

Vec direction_at(const ContourElement& arc, Vec point) {
  const Vec radial = point - arc.centre_mm;
  const Vec along = (1.0 / length(radial)) * left_of(radial);
  return clockwise(arc) ? -1.0 * along : along;
}

struct Circle {
  Vec centre;
  double radius;
};

// Where a root would be negative by rounding alone the circles and lines touch.
double root(double square, double scale) {
  return square > 0.0 ? std::sqrt(square) : square > -1e-9 * scale * scale ? 0.0 : -1.0;
}

Crossings of_lines(Vec a, Vec along_a, Vec b, Vec along_b) {
  const double sine = cross(along_a, along_b);
  if (std::fabs(sine) < 1e-12) {
    return {};
  }
  return {{a + (cross(b - a, along_b) / sine) * along_a, {}}, 1};
}

Crossings of_line_and_circle(Vec point, Vec along, Circle circle) {
  const Vec foot = point + dot(circle.centre - point, along) * along;
  const double away = length(circle.centre - foot);
  const double half = root((circle.radius - away) * (circle.radius + away), circle.radius);
  if (half < 0.0) {
    return {};
  }
  return {{foot - half * along, foot + half * along}, 2};
}

Crossings of_circles(Circle a, Circle b) {
  const Vec between = b.centre - a.centre;
  const double apart = length(between);
  if (apart < 1e-9) {
    return {};
  }
  const double foot = (apart * apart + (a.radius - b.radius) * (a.radius + b.radius)) / (2 * apart);
  const double half = root((a.radius - foot) * (a.radius + foot), a.radius);
  if (half < 0.0) {
    return {};
  }
  const Vec along = (1.0 / apart) * between;
  const Vec middle = a.centre + foot * along;
  return {{middle + half * left_of(along), middle - half * left_of(along)}, 2};
}

}  // namespace

double turn_rad(Vec from, Vec to, bool clockwise) {
  const double turn = std::atan2(cross(from, to), dot(from, to));
  if (clockwise) {
    return turn > 0.0 ? turn - kTurn_rad : turn;
  }
  return turn < 0.0 ? turn + kTurn_rad : turn;
}

Vec start_direction(const ContourElement& curve) {
  if (curve.is_arc()) {
    return direction_at(curve, curve.start_mm);
  }
  const Vec along = curve.end_mm - curve.start_mm;
  return (1.0 / length(along)) * along;
}

Vec end_direction(const ContourElement& curve) {
  return curve.is_arc() ? direction_at(curve, curve.end_mm) : start_direction(curve);
}

double length_mm(const ContourElement& curve) {
  return curve.is_arc()
             ? std::fabs(curve.sweep_rad) * (curve.start_radius_mm() + curve.end_radius_mm()) / 2
             : length(curve.end_mm - curve.start_mm);
}

std::optional<ContourElement> offset(const ContourElement& curve, double left_mm) {
  constexpr double kSmallestRadius_mm = 1e-6;
  if (curve.is_arc()) {
    const double inwards = clockwise(curve) ? -left_mm : left_mm;
    const double radius = std::min(curve.start_radius_mm(), curve.end_radius_mm());
    if (std::min(radius, radius - inwards) < kSmallestRadius_mm) {
      return std::nullopt;
    }
  }
  ContourElement moved = curve;
  moved.start_mm = curve.start_mm + left_mm * left_of(start_direction(curve));
  moved.end_mm = curve.end_mm + left_mm * left_of(end_direction(curve));
  return moved;
}

Crossings crossings(const ContourElement& first, const ContourElement& second) {
  const Circle first_circle{first.centre_mm, first.end_radius_mm()};
  const Circle second_circle{second.centre_mm, second.start_radius_mm()};
  if (first.is_arc()) {
    return second.is_arc()
               ? of_circles(first_circle, second_circle)
               : of_line_and_circle(second.start_mm, start_direction(second), first_circle);
  }
  const Vec along = end_direction(first);
  return second.is_arc() ? of_line_and_circle(first.end_mm, along, second_circle)
                         : of_lines(first.end_mm, along, second.start_mm, start_direction(second));
}

double ahead_of_start_mm(const ContourElement& curve, Vec point_mm) {
  if (!curve.is_arc()) {
    return dot(point_mm - curve.start_mm, start_direction(curve));
  }
  const double turn = std::fabs(
      turn_rad(curve.start_mm - curve.centre_mm, point_mm - curve.centre_mm, clockwise(curve)));
  return turn > kTurn_rad - kAngleNoise_rad ? 0.0 : turn * curve.start_radius_mm();
}

double before_end_mm(const ContourElement& curve, Vec point_mm) {
  if (!curve.is_arc()) {
    return dot(curve.end_mm - point_mm, end_direction(curve));
  }
  const double turn = std::fabs(
      turn_rad(point_mm - curve.centre_mm, curve.end_mm - curve.centre_mm, clockwise(curve)));
  return turn > kTurn_rad - kAngleNoise_rad ? 0.0 : turn * curve.end_radius_mm();
}

ContourElement up_to(const ContourElement& curve, Vec point_mm) {
  ContourElement part = curve;
  part.end_mm = point_mm;
  if (curve.is_arc()) {
    part.sweep_rad =
        turn_rad(curve.start_mm - curve.centre_mm, point_mm - curve.centre_mm, clockwise(curve));
  }
  return part;
}

}  // namespace kerf::parser::planar
