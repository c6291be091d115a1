// A gouge is a point of the contour that is nearer to the way of the tool's centre than the radius.
// That is asked for whole curves at once, by their smallest distance.
//
// The move or two that lead on to a closed contour are no wall: its last moves come back to where
// the first began and cross them, as the moves that lead away cross the first (is_lead).
//
// Weakness: contours at the same depth are all taken for walls to be kept. A pocket that is roughed
// and finished without G40, a rapid or another depth between is refused, if the two passes come
// within one window.
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

double radii_differ_mm(const planar::Curve& curve) {
  return curve.is_arc() ? std::fabs(curve.start_radius_mm() - curve.end_radius_mm()) : 0.0;
}

bool comparable(const HeldMove& mover, const HeldMove& contour) {
  return contour.role == HeldRole::contour && mover.role != HeldRole::idle && mover.run != 0 &&
         mover.run == contour.run && !mover.faulty && !contour.faulty &&
         mover.low_mm <= contour.high_mm + kTolerance_mm &&
         contour.low_mm <= mover.high_mm + kTolerance_mm;
}

double depth_mm(const planar::Curve& way, const planar::Curve& contour, double radius_mm) {
  if (far_apart(way, contour, radius_mm)) {
    return 0.0;
  }
  const double depth = radius_mm - distance_mm(way, contour);
  return depth > kTolerance_mm + radii_differ_mm(way) + radii_differ_mm(contour) ? depth : 0.0;
}

// Whether the programmed path of `back`, other than by following on `lead`, meets the joint: a full
// circle does by its other end.
bool comes_back(const HeldMove& back, const HeldMove& lead, const planar::Vec& joint) {
  constexpr double kSamePlace_mm = 1e-3;
  const planar::Curve& path = back.curve.programmed;
  const std::uint64_t apart =
      back.number > lead.number ? back.number - lead.number : lead.number - back.number;
  if (apart == 0) {
    return false;
  }
  if (apart == 1) {
    const planar::Vec other = back.number > lead.number ? path.end_mm : path.start_mm;
    return length(other - joint) < kSamePlace_mm;
  }
  return distance_mm(path, {joint, joint, {}}) < kSamePlace_mm;
}

}  // namespace

double depth_of_cut_mm(const HeldMove& mover, const HeldMove& contour, double radius_mm) {
  if (!comparable(mover, contour)) {
    return 0.0;
  }
  double depth = depth_mm(mover.way, contour.curve.programmed, radius_mm);
  if (mover.has_corner && !mover.corner_is_of_entry) {
    depth = std::max(depth, depth_mm(mover.corner, contour.curve.programmed, radius_mm));
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

bool is_lead(const std::deque<HeldMove>& held, const HeldMove& mover, const HeldMove& contour) {
  const bool towards = contour.number < mover.number;
  const std::uint64_t next = towards ? contour.number + 1 : contour.number - 1;
  for (const HeldMove& lead : held) {
    if (lead.role != HeldRole::contour || (lead.number != contour.number && lead.number != next)) {
      continue;
    }
    const planar::Curve& path = lead.curve.programmed;
    const planar::Vec joint = towards ? path.end_mm : path.start_mm;
    for (const HeldMove& back : held) {
      if (back.role == HeldRole::contour && back.number + 1 >= mover.number &&
          back.number <= mover.number + 1 && comes_back(back, lead, joint)) {
        return true;
      }
    }
  }
  return false;
}

bool meet_at_seam(const HeldMove& mover, const HeldMove& contour) {
  constexpr double kSamePlace_mm = 1e-3;
  const bool later = contour.number > mover.number;
  const HeldMove& first = later ? mover : contour;
  const HeldMove& last = later ? contour : mover;
  return last.number > first.number + 1 &&
         length(first.curve.programmed.start_mm - last.curve.programmed.end_mm) < kSamePlace_mm;
}

}  // namespace kerf::parser
