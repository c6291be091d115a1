// An inside corner's meeting point is the one that costs the two curves least, since a circle meets
// its neighbour twice. For two lines it is computed from the mean of their normals, which stays
// exact where the corner is nearly straight and the crossing of two lines would be lost.
//
// Corners that are straight within kSmooth_mm get one point and no arc. LinuxCNC does so up to 0.05
// rad, which leaves the tool up to 1.2 per mille of its radius inside the contour; see
// tests/parser/compensation for where the end points differ.
#include "parser/compensation/corner.hpp"

#include <algorithm>

namespace kerf::parser {

namespace {

using planar::Vec;

// How far the tool may be inside the contour where a corner is taken for straight.
constexpr double kSmooth_mm = 5e-7;

OffsetCorner smooth_corner(const OffsetCurve& first, const OffsetCurve& second, double left_mm) {
  OffsetCorner corner;
  corner.kind = CornerKind::smooth;
  if (first.path.is_arc()) {
    corner.first_end_mm = first.path.end_mm;
  } else if (second.path.is_arc()) {
    corner.first_end_mm = second.path.start_mm;
  } else {
    const Vec normals =
        left_of(end_direction(first.programmed)) + left_of(start_direction(second.programmed));
    corner.first_end_mm =
        second.programmed.start_mm + (2 * left_mm / dot(normals, normals)) * normals;
  }
  corner.second_start_mm = corner.first_end_mm;
  return corner;
}

OffsetCorner inside_corner(const OffsetCurve& first, const OffsetCurve& second, double left_mm) {
  OffsetCorner corner;
  corner.kind = CornerKind::too_tight;
  planar::Crossings meet = crossings(first.path, second.path);
  if (!first.path.is_arc() && !second.path.is_arc()) {
    const Vec normals =
        left_of(end_direction(first.programmed)) + left_of(start_direction(second.programmed));
    meet.points_mm[0] =
        second.programmed.start_mm + (2 * left_mm / dot(normals, normals)) * normals;
    meet.count = 1;
  }
  constexpr double kNoise_mm = 1e-9;
  double least = 0.0;
  for (std::size_t i = 0; i < meet.count; ++i) {
    const double first_loses = before_end_mm(first.path, meet.points_mm[i]);
    const double second_loses = ahead_of_start_mm(second.path, meet.points_mm[i]);
    if (first_loses < -kNoise_mm || second_loses < -kNoise_mm ||
        (corner.kind == CornerKind::inside && first_loses + second_loses >= least)) {
      continue;
    }
    least = first_loses + second_loses;
    corner = {CornerKind::inside, meet.points_mm[i], meet.points_mm[i], std::max(0.0, first_loses),
              std::max(0.0, second_loses)};
  }
  return corner;
}

// To the left positive.
double bend_per_mm(const planar::ContourElement& curve) {
  return !curve.is_arc() ? 0.0 : std::copysign(1.0 / curve.start_radius_mm(), curve.sweep_rad);
}

// Where the second curve leaves the way the first came, their bends tell which of them is on which
// side, not the angle, whose sign may be chance. Two lines straight back are an outside corner.
bool turns_back(double sine, double cosine, const OffsetCurve& first, const OffsetCurve& second) {
  constexpr double kStraightBack = 1e-12;
  constexpr double kStraightBackOfArcs = 1e-3;
  const bool bends = bend_per_mm(first.programmed) + bend_per_mm(second.programmed) != 0.0;
  return cosine < 0.0 && std::fabs(sine) < (bends ? kStraightBackOfArcs : kStraightBack);
}

}  // namespace

OffsetCorner corner_between(const OffsetCurve& first, const OffsetCurve& second, double left_mm) {
  const Vec before = end_direction(first.programmed);
  const Vec after = start_direction(second.programmed);
  const double sine = cross(before, after);
  const double cosine = dot(before, after);
  if (cosine > 0.0 && std::fabs(left_mm) * sine * sine < 2 * kSmooth_mm) {
    return smooth_corner(first, second, left_mm);
  }
  const bool inside =
      turns_back(sine, cosine, first, second)
          ? (bend_per_mm(first.programmed) + bend_per_mm(second.programmed)) * left_mm < 0.0
          : (sine > 0.0) == (left_mm > 0.0);
  if (inside) {
    return inside_corner(first, second, left_mm);
  }
  return {CornerKind::outside, first.path.end_mm, second.path.start_mm};
}

}  // namespace kerf::parser
