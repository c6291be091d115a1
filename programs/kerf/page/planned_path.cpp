#include "programs/kerf/page/planned_path.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "curves/curve.hpp"

namespace kerf::program {

namespace {

// Points on what is no line: so many for each length of the whole path's size, and at most.
constexpr double kPointsOfSize = 5000.0;
constexpr double kMostPoints = 20'000.0;
constexpr double kNm_mm = 1e-6;

double longest_side_mm(const curves::Extents& extents) {
  double size_mm = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    size_mm = std::max(size_mm, extents.max_mm[k] - extents.min_mm[k]);
  }
  return size_mm;
}

int points_on(const curves::Curve& curve, double share_of_size) {
  if (std::holds_alternative<curves::Line>(curve)) {
    return 1;
  }
  return static_cast<int>(std::clamp(std::ceil(kPointsOfSize * share_of_size), 8.0, kMostPoints));
}

}  // namespace

double drawn_tolerance_mm(const curves::Extents& extents) {
  constexpr double kShareOfSize = 1e-6;
  constexpr double kFinest_mm = 1e-6;
  return std::max(kShareOfSize * longest_side_mm(extents), kFinest_mm);
}

PlannedPath::PlannedPath(const curves::Extents& extents)
    : size_mm_(std::max(longest_side_mm(extents), kNm_mm)),
      outline_({.tolerance_mm = drawn_tolerance_mm(extents)}) {}

void PlannedPath::add(const smoothing::PathSegment& segment) {
  const double length_mm = curves::length_mm(segment.curve);
  const int points = points_on(segment.curve, length_mm / size_mm_);
  for (int i = 0; i <= points; ++i) {
    const double s_mm = length_mm * i / points;
    const std::int64_t tick = std::llround((length_mm_ + s_mm) / kNm_mm);
    // Where two segments meet there is one point.
    if (tick > last_tick_) {
      last_tick_ = tick;
      outline_.add({.tick = tick,
                    .position_mm = curves::position_at(segment.curve, s_mm),
                    .rapid = segment.rapid});
    }
  }
  length_mm_ += length_mm;
}

}  // namespace kerf::program
