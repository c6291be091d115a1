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
  Position centre_mm{};    // the component along normal_axis is not used
  int normal_axis = 2;     // 0, 1 or 2: the arc lies in the plane of the two others
  bool clockwise = false;  // seen against the direction of the normal axis: in the plane (x, y) of
                           // normal 2, (y, z) of normal 0, (z, x) of normal 1
  int turns = 1;           // as in parser::ArcMove
};

// How an ArcShape looks in its plane, seen from the centre, whether or not its radii agree.
struct ArcSweep {
  Eigen::Vector2d from_centre_mm{};  // to the start, in the plane's right-handed axes
  Eigen::Vector2d chord_mm{};        // from the start to the end
  double start_radius_mm = 0.0;
  double end_radius_mm = 0.0;
  double angle_rad = 0.0;  // > 0, turns included
  double rise_mm = 0.0;    // along the normal axis
};

// Errors: as Arc::make, except radii that differ. An end within 1e-11 mm of the start in the plane
// makes a full circle.
tl::expected<ArcSweep, CurveError> sweep_of(const ArcShape& shape);

class Arc {
 public:
  // Start and end at one distance from the centre within 1e-9 mm; make_arc in curve_builders.hpp
  // takes what programs really hold. Error: zero radius, radii differ, not finite or beyond
  // kMaxCoordinate_mm, turns < 1, no such axis.
  static tl::expected<Arc, CurveError> make(const ArcShape& shape);

  // From begin_mm to end_mm along it. Precondition: 0 <= begin < end <= length.
  [[nodiscard]] Arc part(const Stretch& stretch) const noexcept;

  [[nodiscard]] double length_mm() const noexcept { return length_mm_; }
  [[nodiscard]] double radius_mm() const noexcept { return radius_mm_; }
  [[nodiscard]] int normal_axis() const noexcept { return normal_axis_; }
  // Length of the unit tangent's part in the plane of the arc: 1 for a circle, less for a helix.
  [[nodiscard]] double in_plane_share() const noexcept { return in_plane_share_; }
  // Signed part of the unit tangent along the normal axis.
  [[nodiscard]] double normal_share() const noexcept { return normal_share_; }
  // s_mm is clamped to [0, length]; both ends are exact.
  [[nodiscard]] Position at(double s_mm) const noexcept;
  [[nodiscard]] PathDerivatives derivatives_at(double s_mm) const noexcept;
  [[nodiscard]] Extents extents() const noexcept;  // with the bulge

 private:
  Arc() = default;
  Position start_mm_{};
  Position end_mm_{};
  // In the plane's right-handed axes: the start seen from the centre, and a quarter turn on.
  std::array<double, 2> outward_mm_{};
  std::array<double, 2> forward_mm_{};
  double radius_mm_ = 0.0;
  double rad_per_mm_ = 0.0;  // > 0: angle swept by length
  double in_plane_share_ = 1.0;
  double normal_share_ = 0.0;
  double length_mm_ = 0.0;
  std::int8_t first_axis_ = 0;
  std::int8_t second_axis_ = 1;
  std::int8_t normal_axis_ = 2;
};

}  // namespace kerf::curves
