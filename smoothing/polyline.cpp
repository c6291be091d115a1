#include "smoothing/polyline.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <Eigen/Geometry>

namespace kerf::smoothing {

using curves::vec;

namespace {

constexpr double kChordHeight = 1.5;     // tolerances that a curve may rise over a chord
constexpr double kSlightTurn_rad = 0.1;  // less is no corner, however it comes about
constexpr double kCornerTurn_rad = 0.35;
constexpr double kStandsOut = 2.5;  // a corner's turn, over those before and after it
constexpr double kNear = 4.0;       // tolerances over which a direction is taken
constexpr double kFar = 3.0;        // times as far for the directions before and after
constexpr double kLongLine = 10.0;  // times its neighbour
constexpr double kLong = 100.0;     // tolerances
// A run is straight where it bends by less than a circle of this radius, or within rounding.
constexpr double kStraightRadius_mm = 1e5;
constexpr double kStraight_mm = 1e-6;
constexpr double kOfTolerance = 0.2;

// The vertex at least so far away along the run, or the run's end.
std::size_t walk(const Polyline& run, std::size_t from, double way_mm, bool forward) {
  std::size_t i = from;
  while (forward ? i + 1 < run.size() : i > 0) {
    i = forward ? i + 1 : i - 1;
    if (std::abs(run[i].w_mm - run[from].w_mm) >= way_mm) {
      break;
    }
  }
  return i;
}

// How the run turns on one side of a vertex, between the near and the far direction.
double turn_beside(const Polyline& run, std::size_t index, std::size_t near, bool forward) {
  const double way = std::abs(run[near].w_mm - run[index].w_mm);
  const std::size_t far = walk(run, near, (kFar - 1.0) * way, forward);
  if (far == near) {
    return 0.0;
  }
  const Eigen::Vector3d inner = vec(run[near].point_mm) - vec(run[index].point_mm);
  const Eigen::Vector3d outer = vec(run[far].point_mm) - vec(run[near].point_mm);
  return turn_rad(inner, outer);
}

}  // namespace

double turn_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

bool is_corner(const Polyline& run, std::size_t index, double tolerance_mm) {
  assert(0 < index && index + 1 < run.size() && tolerance_mm > 0.0);
  const Eigen::Vector3d here = vec(run[index].point_mm);
  const Eigen::Vector3d in = here - vec(run[index - 1].point_mm);
  const Eigen::Vector3d out = vec(run[index + 1].point_mm) - here;
  const double in_mm = in.norm();
  const double out_mm = out.norm();
  const double turn = turn_rad(in, out);
  const auto [shorter, longer] = std::minmax(in_mm, out_mm);
  if (shorter * turn > 8.0 * kChordHeight * tolerance_mm) {
    return true;
  }
  if (longer > kLongLine * shorter && longer > kLong * tolerance_mm) {
    return true;
  }
  if (turn < kSlightTurn_rad) {
    return false;
  }
  const std::size_t back = walk(run, index, std::max(kNear * tolerance_mm, in_mm), false);
  const std::size_t ahead = walk(run, index, std::max(kNear * tolerance_mm, out_mm), true);
  // Over less than that the direction is noise, at the run's ends too: whether a curve can follow
  // is for the fit to say.
  const double known_mm =
      std::min(run[index].w_mm - run[back].w_mm, run[ahead].w_mm - run[index].w_mm);
  if (known_mm < kNear * tolerance_mm) {
    return false;
  }
  const double near = turn_rad(here - vec(run[back].point_mm), vec(run[ahead].point_mm) - here);
  return near > kCornerTurn_rad &&
         near > kStandsOut * std::max(turn_beside(run, index, back, false),
                                      turn_beside(run, index, ahead, true));
}

bool is_straight(const Polyline& run, std::size_t last, double tolerance_mm) {
  assert(last < run.size());
  const Eigen::Vector3d begin = vec(run[0].point_mm);
  const Eigen::Vector3d chord = vec(run[last].point_mm) - begin;
  const double length = chord.norm();
  const double most =
      std::max(std::min(kStraight_mm, tolerance_mm),
               std::min(kOfTolerance * tolerance_mm, 0.125 * length * length / kStraightRadius_mm));
  double before = 0.0;
  for (std::size_t i = 1; i < last; ++i) {
    const Eigen::Vector3d seen = vec(run[i].point_mm) - begin;
    const double along = seen.dot(chord) / length;
    const double aside = (seen - (along / length) * chord).norm();
    if (!(aside <= most && along > before && along < length)) {
      return false;
    }
    before = along;
  }
  return length > 0.0;
}

}  // namespace kerf::smoothing
