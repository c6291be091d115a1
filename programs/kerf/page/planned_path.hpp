// Where a path goes, before any time is known: of a program that leaves the travel, and of one
// whose plan takes a while.
#pragma once

#include <cstdint>

#include "programs/kerf/page/timed_path.hpp"
#include "smoothing/path_segment.hpp"

namespace kerf::program {

// How far a drawn path of this size may be from what it stands for, as long as there are points.
[[nodiscard]] double drawn_tolerance_mm(const curves::Extents& extents);

class PlannedPath {
 public:
  // extents: of the whole path.
  explicit PlannedPath(const curves::Extents& extents);

  // In the order of the path.
  void add(const smoothing::PathSegment& segment);

  // Points as of a run, but "ticks" are nanometres along the path.
  [[nodiscard]] const TimedPath& outline() const noexcept { return outline_; }

 private:
  double size_mm_;
  double length_mm_ = 0.0;
  TimedPath outline_;
  std::int64_t last_tick_ = -1;
};

}  // namespace kerf::program
