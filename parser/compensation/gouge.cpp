// A gouge is a point of the contour that is nearer to the way of the tool's centre than the radius.
// That is asked for whole curves at once, by their smallest distance.
//
// Weakness: contours at the same depth are all taken for walls to be kept. A pocket that is roughed
// and finished without G40, a rapid or another depth between is refused, if the two passes come
// within one window.
//
// Arcs and lines that lead in and out are in the air; every closed contour passes over them. So the
// first move after the entry is no wall, nor is what comes before the place where a contour closes
// and the two moves after that. Little is lost by it: where two walls are too near to each other
// the tool's way past either of them cuts into the other.
//
// An entry goes straight to the point beside the contour's first one, so it passes that point a
// little nearer than the radius R: by R (1 - cos a) with tan a = R / length, at most 0.29 R since
// the entry is longer than R. LinuxCNC's does the same; it is how the entry is defined.
#include "parser/compensation/gouge.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::parser {

namespace {

constexpr double kTolerance_mm = 1e-6;
constexpr double kDeepestNick = 0.3;  // of the radius
constexpr double kSamePlace_mm = 1e-3;

bool on_curve(planar::Vec place_mm, const HeldMove& move) {
  const planar::ContourElement point{place_mm, place_mm, {}};
  return !far_apart(point, move.curve.programmed, kSamePlace_mm) &&
         distance_mm(point, move.curve.programmed) < kSamePlace_mm;
}

double radii_differ_mm(const planar::ContourElement& curve) {
  return curve.is_arc() ? std::fabs(curve.start_radius_mm() - curve.end_radius_mm()) : 0.0;
}

bool comparable(const HeldMove& mover, const HeldMove& contour) {
  return contour.role == HeldRole::contour && mover.role != HeldRole::idle && mover.run != 0 &&
         mover.run == contour.run && !mover.faulty && !contour.faulty &&
         mover.low_mm <= contour.high_mm + kTolerance_mm &&
         contour.low_mm <= mover.high_mm + kTolerance_mm &&
         (!contour.lead || mover.role == HeldRole::entry ||
          (mover.role == HeldRole::exit && contour.number + 1 == mover.number));
}

double depth_mm(const planar::ContourElement& way, const planar::ContourElement& contour,
                double radius_mm) {
  if (far_apart(way, contour, radius_mm)) {
    return 0.0;
  }
  const double depth = radius_mm - distance_mm(way, contour);
  return depth > kTolerance_mm + radii_differ_mm(way) + radii_differ_mm(contour) ? depth : 0.0;
}

}  // namespace

double depth_of_cut_mm(const HeldMove& mover, const HeldMove& contour, double radius_mm) {
  if (!comparable(mover, contour)) {
    return 0.0;
  }
  double depth = depth_mm(mover.way, contour.wall, radius_mm);
  if (mover.has_corner && !mover.corner_is_of_entry) {
    depth = std::max(depth, depth_mm(mover.corner, contour.wall, radius_mm));
  }
  if (depth > 0.0 && mover.role != HeldRole::contour) {
    const planar::Vec end = mover.role == HeldRole::entry ? mover.curve.programmed.end_mm
                                                          : mover.curve.programmed.start_mm;
    const double nick = radius_mm - distance_mm(mover.way, {end, end, {}});
    if (nick < kDeepestNick * radius_mm && depth <= nick + kTolerance_mm) {
      return 0.0;
    }
  }
  return depth;
}

bool starts_on(const HeldMove& move, const HeldMove& other) {
  return on_curve(move.curve.programmed.start_mm, other);
}

bool ends_on(const HeldMove& move, const HeldMove& other) {
  return on_curve(move.curve.programmed.end_mm, other);
}

bool is_closed(const HeldMove& move) {
  const planar::ContourElement& curve = move.curve.programmed;
  return length(curve.start_mm - curve.end_mm) < kSamePlace_mm;
}

bool meet_at_seam(const HeldMove& mover, const HeldMove& contour) {
  const bool later = contour.number > mover.number;
  const HeldMove& first = later ? mover : contour;
  const HeldMove& last = later ? contour : mover;
  return last.number > first.number + 1 &&
         length(first.curve.programmed.start_mm - last.wall.end_mm) < kSamePlace_mm;
}

}  // namespace kerf::parser
