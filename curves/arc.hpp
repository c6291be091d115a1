// A circular arc or a helix about one of the machine's axes, exact.
#pragma once

#include <cstdint>

#include <tl/expected.hpp>

#include "curves/curve_error.hpp"
#include "curves/position.hpp"

namespace kerf::curves {

struct ArcShape {
  Position start_mm{};
  Position end_mm{};
  Position centre_mm{};  // the component along normal_axis is not used
  int normal_axis = 2;   // 0, 1 or 2: the arc lies in the plane of the two others
  bool clockwise = false;
  int turns = 1;  // as in parser::ArcMove
};

class Arc {
 public:
  // Start and end at one distance from the centre within 1e-9 mm; make_arc in arc_builder.hpp
  // takes what programs really hold. Error: zero radius, radii differ, not finite, turns < 1.
  static tl::expected<Arc, CurveError> make(const ArcShape& shape);

  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  [[nodiscard]] double radius_mm() const noexcept { return radius_mm_; }
  [[nodiscard]] int normal_axis() const noexcept { return normal_axis_; }
  // Length of the unit tangent's part in the plane of the arc: 1 for a circle, less for a helix.
  [[nodiscard]] double in_plane_share() const noexcept { return in_plane_share_; }
  // Signed part of the unit tangent along the normal axis.
  [[nodiscard]] double normal_share() const noexcept { return normal_share_; }
  [[nodiscard]] Position at(double s_mm) const noexcept;
  [[nodiscard]] PathDerivatives derivatives_at(double s_mm) const noexcept;
  [[nodiscard]] Extents extents() const noexcept;  // with the bulge

 private:
  Arc() = default;
  Position centre_mm_{};  // at the height of the start
  Position end_mm_{};
  double radius_mm_ = 0.0;
  double angle_begin_rad_ = 0.0;
  double angle_per_mm_ = 0.0;  // signed: d(angle)/ds
  double in_plane_share_ = 1.0;
  double normal_share_ = 0.0;
  double length_mm_ = 0.0;
  std::int8_t normal_axis_ = 2;
};

}  // namespace kerf::curves
