// A straight line.
#pragma once

#include <tl/expected.hpp>

#include "curves/curve_error.hpp"
#include "curves/position.hpp"

namespace kerf::curves {

class Line {
 public:
  // Error: the two points are equal (zero length), not finite or beyond kMaxCoordinate_mm.
  static tl::expected<Line, CurveError> between(const Position& start_mm, const Position& end_mm);

  // A line that stays at one point: for a move on which only other axes move, along which s counts
  // their distance. Error: the point is not usable, or the length is not positive and finite.
  static tl::expected<Line, CurveError> resting(const Position& point_mm, double length_mm);

  // From begin_mm to end_mm along it. Precondition: 0 <= begin < end <= length.
  [[nodiscard]] Line part(const Stretch& stretch) const noexcept;

  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  [[nodiscard]] const Position& direction() const noexcept { return direction_; }
  // s_mm is clamped to [0, length]; both ends are exact.
  [[nodiscard]] Position at(double s_mm) const noexcept;
  [[nodiscard]] PathDerivatives derivatives_at(double s_mm) const noexcept;
  [[nodiscard]] Extents extents() const noexcept;

 private:
  Line() = default;
  Position start_mm_{};
  Position end_mm_{};
  Position direction_{};
  double length_mm_ = 0.0;
};

}  // namespace kerf::curves
