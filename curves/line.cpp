#include "curves/line.hpp"

#include <algorithm>
#include <cassert>

namespace kerf::curves {

tl::expected<Line, CurveError> Line::between(const Position& start_mm, const Position& end_mm) {
  if (!is_usable(start_mm) || !is_usable(end_mm)) {
    const bool start_bad = !is_usable(start_mm);
    return tl::unexpected(CurveError{"the line's " + std::string(start_bad ? "start " : "end ") +
                                         to_text(start_bad ? start_mm : end_mm) +
                                         " is not finite or beyond 1e9 mm",
                                     CurveError::Where::point, start_bad ? 0U : 1U});
  }
  const Eigen::Vector3d chord = vec(end_mm) - vec(start_mm);
  const double length_mm = chord.stableNorm();
  if (!(length_mm > 0.0)) {
    return tl::unexpected(
        CurveError{"the line has no length: it starts and ends at " + to_text(end_mm)});
  }
  Line line;
  line.start_mm_ = start_mm;
  line.end_mm_ = end_mm;
  line.direction_ = to_position(chord.stableNormalized());
  line.length_mm_ = length_mm;
  return line;
}

tl::expected<Line, CurveError> Line::resting(const Position& point_mm, double length_mm) {
  if (!is_usable(point_mm)) {
    return tl::unexpected(
        CurveError{"the point " + to_text(point_mm) + " is not finite or beyond 1e9 mm",
                   CurveError::Where::point, 0U});
  }
  if (!(length_mm > 0.0) || !is_usable(length_mm)) {
    return tl::unexpected(CurveError{"the way of the extra axes has no usable length"});
  }
  Line line;
  line.start_mm_ = line.end_mm_ = point_mm;
  line.length_mm_ = length_mm;
  return line;
}

Line Line::part(const Stretch& stretch) const noexcept {
  assert(0.0 <= stretch.begin_mm && stretch.begin_mm < stretch.end_mm);
  assert(stretch.end_mm <= length_mm_);
  Line line = *this;
  line.start_mm_ = at(stretch.begin_mm);
  line.end_mm_ = at(stretch.end_mm);
  line.length_mm_ = stretch.end_mm - stretch.begin_mm;
  return line;
}

Position Line::at(double s_mm) const noexcept {
  if (s_mm >= length_mm_) {
    return end_mm_;
  }
  if (!(s_mm > 0.0)) {
    return start_mm_;
  }
  return {start_mm_[0] + s_mm * direction_[0], start_mm_[1] + s_mm * direction_[1],
          start_mm_[2] + s_mm * direction_[2]};
}

PathDerivatives Line::derivatives_at(double s_mm) const noexcept {
  return {.position_mm = at(s_mm), .first = direction_, .second_per_mm = {}, .third_per_mm2 = {}};
}

Extents Line::extents() const noexcept {
  Extents box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.min_mm[k] = std::min(start_mm_[k], end_mm_[k]);
    box.max_mm[k] = std::max(start_mm_[k], end_mm_[k]);
  }
  return box;
}

}  // namespace kerf::curves
