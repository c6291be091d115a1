// Lines and arcs in the plane of cutter compensation: offsets, meeting points and distances.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

namespace kerf::parser::planar {

inline constexpr double kTurn_rad = 2 * 3.14159265358979323846;

// A point or a direction, along the plane's first and second axis.
struct Vec {
  double x = 0.0;
  double y = 0.0;

  friend constexpr Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec operator*(double k, Vec a) { return {k * a.x, k * a.y}; }
  friend constexpr bool operator==(Vec a, Vec b) { return a.x == b.x && a.y == b.y; }
};

constexpr double dot(Vec a, Vec b) {
  return a.x * b.x + a.y * b.y;
}
constexpr double cross(Vec a, Vec b) {
  return a.x * b.y - a.y * b.x;
}
constexpr Vec left_of(Vec direction) {
  return {-direction.y, direction.x};
}
inline double length(Vec a) {
  return std::sqrt(dot(a, a));  // coordinates are far from where squares overflow
}
inline double angle_rad(Vec a) {
  return std::atan2(a.y, a.x);
}

// A line, or an arc about `centre_mm`. The radii at an arc's ends may differ by what the control
// tolerates; neither is 0. A line is longer than 0 unless both its ends were cut back to one point.
struct ContourElement {
  Vec start_mm;
  Vec end_mm;
  Vec centre_mm;           // of an arc
  double sweep_rad = 0.0;  // counterclockwise positive, whole turns included; 0: a line

  [[nodiscard]] bool is_arc() const { return sweep_rad != 0.0; }
  [[nodiscard]] double start_radius_mm() const { return length(start_mm - centre_mm); }
  [[nodiscard]] double end_radius_mm() const { return length(end_mm - centre_mm); }
};

// From the first to the second, less than a turn: counterclockwise in [0, 2 pi), clockwise in
// (-2 pi, 0].
double turn_rad(Vec from, Vec to, bool clockwise);

Vec start_direction(const ContourElement& curve);  // unit length, the way of travel
Vec end_direction(const ContourElement& curve);
double length_mm(const ContourElement& curve);  // of an arc with the mean of its radii

// The curve moved `left_mm` to the left of its travel (negative: right). Nothing where that is at
// or beyond an arc's centre, or the arc is but a point.
std::optional<ContourElement> offset(const ContourElement& curve, double left_mm);

// Where the curves meet if each is carried on beyond its ends; an arc with two radii has the one
// next to the junction, which is the first's end and the second's start.
struct Crossings {
  std::array<Vec, 2> points_mm;
  std::size_t count = 0;
};
Crossings crossings(const ContourElement& first, const ContourElement& second);

// How far along the curve the point, which lies on it or its continuation, is after its start or
// before its end; negative if outside a line.
double ahead_of_start_mm(const ContourElement& curve, Vec point_mm);
double before_end_mm(const ContourElement& curve, Vec point_mm);

// The curve up to the point, which lies on it.
ContourElement up_to(const ContourElement& curve, Vec point_mm);

// The smallest distance between two curves, 0 where they cross.
double distance_mm(const ContourElement& a, const ContourElement& b);

// Whether the curves are certainly farther apart than that, told at little cost.
bool far_apart(const ContourElement& a, const ContourElement& b, double distance_mm);

}  // namespace kerf::parser::planar
