#include <numbers>

#include "smoothing/run_fit.hpp"

namespace kerf::smoothing {

using curves::vec;

namespace {

// Of the angle between the two sides of a corner. With that goes the feedrate at which a sharp one
// is passed, so the joint costs no more than a tenth of it.
constexpr double kOfOpening = 0.9;

// Directions along the path at one end of a stretch.
struct Joint {
  Eigen::Vector3d lines;   // of the stretch
  Eigen::Vector3d beside;  // of what joins them
};

// Not where the lines lead back to where they begin.
bool is_sharper(const Eigen::Vector3d& spline, const Joint& joint) {
  const double opening_rad = std::numbers::pi - turn_rad(joint.lines, joint.beside);
  return !joint.lines.isZero(0.0) &&
         std::numbers::pi - turn_rad(spline, joint.beside) < kOfOpening * opening_rad;
}

// Vertices; either may be the first of them on the path.
struct Way {
  std::size_t from = 0;
  std::size_t to = 0;
};

// To the first vertex of the way that is at least so far from its begin, or to its end: the
// direction of shorter lines is noise.
Eigen::Vector3d direction_of(const Polyline& run, const Way& vertices, double over_mm) {
  const auto [from, to] = vertices;
  std::size_t i = from;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  do {
    i = from < to ? i + 1 : i - 1;
    way = vec(run[i].point_mm) - vec(run[from].point_mm);
  } while (i != to && way.norm() < over_mm);
  return way.normalized();
}

// A shorter one would have to bend like a hook.
bool may_bend(const FitSpan& span, double tolerance_mm) {
  return span.w_end_mm - span.w_begin_mm >= tolerance_mm;
}

}  // namespace

bool hold_ends(const Polyline& run, const RunStretch& stretch, const SplineFit& spline,
               double tolerance_mm, FitEnds& ends) {
  bool held = false;
  if (!ends.tail && !ends.begin_direction) {
    const Eigen::Vector3d lines = direction_of(run, {.from = 0, .to = stretch.last}, tolerance_mm);
    const FitSpan& first = spline.spans.front();
    if (may_bend(first, tolerance_mm) &&
        is_sharper(first.derivative(first.w_begin_mm),
                   {.lines = lines, .beside = stretch.before.value_or(lines)})) {
      ends.begin_direction = lines;
      held = true;
    }
  }
  const bool is_free = !ends.tail || spline.spans.size() > 1;
  if (stretch.pinned && !ends.end_direction && is_free) {
    const Eigen::Vector3d lines = -direction_of(run, {.from = stretch.last, .to = 0}, tolerance_mm);
    const std::size_t end = run.size() - 1;
    const Eigen::Vector3d after =
        stretch.last < end ? direction_of(run, {.from = stretch.last, .to = end}, tolerance_mm)
                           : lines;
    const FitSpan& last = spline.spans.back();
    if (may_bend(last, tolerance_mm) &&
        is_sharper(last.derivative(last.w_end_mm), {.lines = lines, .beside = after})) {
      ends.end_direction = lines;
      held = true;
    }
  }
  return held;
}

}  // namespace kerf::smoothing
