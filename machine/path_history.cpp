#include "machine/path_history.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::machine {
namespace {

double squared_distance(const curves::Position& a, const curves::Position& b) {
  return (curves::vec(a) - curves::vec(b)).squaredNorm();
}

struct Segment {
  const curves::Position& from;
  const curves::Position& to;
};

double squared_distance(const curves::Position& point, const Segment& segment) {
  const Eigen::Vector3d along = curves::vec(segment.to) - curves::vec(segment.from);
  const Eigen::Vector3d offset = curves::vec(point) - curves::vec(segment.from);
  const double squared_length = along.squaredNorm();
  const double share =
      squared_length > 0.0 ? std::clamp(offset.dot(along) / squared_length, 0.0, 1.0) : 0.0;
  return (offset - share * along).squaredNorm();
}

}  // namespace

void PathHistory::restart(const curves::Position& point_mm) noexcept {
  newest_ = 0;
  count_ = 1;
  ring_[0] = {.point_mm = point_mm, .length_mm = 0.0};
}

void PathHistory::append(const curves::Position& point_mm) noexcept {
  // The newest vertex moves along until it is far enough from the one before it.
  if (count_ == 1 || ring_[newest_].length_mm >= kVertexSpacingMm) {
    newest_ = (newest_ + 1) % kCapacity;
    count_ = std::min(count_ + 1, kCapacity);
  }
  const curves::Position& previous_mm = ring_[before(newest_)].point_mm;
  ring_[newest_] = {.point_mm = point_mm,
                    .length_mm = std::sqrt(squared_distance(point_mm, previous_mm))};
}

double PathHistory::distance_mm(const curves::Position& actual_mm) const noexcept {
  double nearest_mm2 = squared_distance(actual_mm, ring_[newest_].point_mm);
  double left_mm = 4.0 * std::sqrt(nearest_mm2);
  std::size_t end = newest_;
  for (std::size_t i = 1; i < count_ && left_mm >= 0.0; ++i) {
    const std::size_t start = before(end);
    const Segment segment{.from = ring_[start].point_mm, .to = ring_[end].point_mm};
    nearest_mm2 = std::min(nearest_mm2, squared_distance(actual_mm, segment));
    left_mm -= ring_[end].length_mm;
    end = start;
  }
  return std::sqrt(nearest_mm2);
}

}  // namespace kerf::machine
