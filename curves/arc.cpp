#include "curves/arc.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace kerf::curves {
namespace {

constexpr double kFullTurn_rad = 2.0 * std::numbers::pi;
constexpr double kClosedChord_mm = 1e-11;
constexpr double kRadiusTolerance_mm = 1e-9;

tl::unexpected<CurveError> error(std::string message) {
  return tl::unexpected(CurveError{std::move(message)});
}

std::size_t axis(int index) {
  return static_cast<std::size_t>(index);
}

Eigen::Vector2d in_plane(const Position& p_mm, int normal_axis) {
  return {p_mm[axis((normal_axis + 1) % 3)], p_mm[axis((normal_axis + 2) % 3)]};
}

double largest_coordinate_mm(const ArcShape& shape) {
  return std::max({vec(shape.start_mm).cwiseAbs().maxCoeff(),
                   vec(shape.end_mm).cwiseAbs().maxCoeff(),
                   in_plane(shape.centre_mm, shape.normal_axis).cwiseAbs().maxCoeff()});
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Angle in (0, 2 pi] from the start to the end as seen from the centre, in the sense of rotation.
double swept_angle_rad(const ArcSweep& sweep, bool clockwise) {
  if (sweep.chord_mm.norm() <= kClosedChord_mm) {
    return kFullTurn_rad;
  }
  const Eigen::Vector2d end_mm = sweep.from_centre_mm + sweep.chord_mm;
  // The chord, not the end, keeps the digits of a short arc of large radius.
  const double sine = cross(sweep.from_centre_mm, sweep.chord_mm);
  const double angle_rad = std::atan2(clockwise ? -sine : sine, sweep.from_centre_mm.dot(end_mm));
  return angle_rad > 0.0 ? angle_rad : angle_rad + kFullTurn_rad;
}

}  // namespace

tl::expected<ArcSweep, CurveError> sweep_of(const ArcShape& shape) {
  if (shape.normal_axis < 0 || shape.normal_axis > 2) {
    return error("the arc's normal axis is " + std::to_string(shape.normal_axis) +
                 ", expected 0, 1 or 2");
  }
  if (shape.turns < 1) {
    return error("the arc makes " + std::to_string(shape.turns) + " turns, expected 1 or more");
  }
  const Eigen::Vector2d centre_mm = in_plane(shape.centre_mm, shape.normal_axis);
  if (!is_usable(shape.start_mm) || !is_usable(shape.end_mm) || !is_usable(centre_mm.x()) ||
      !is_usable(centre_mm.y())) {
    return error("the arc from " + to_text(shape.start_mm) + " to " + to_text(shape.end_mm) +
                 " about " + to_text(shape.centre_mm) +
                 " has a coordinate that is not finite or beyond 1e9 mm");
  }
  const Eigen::Vector2d start_mm = in_plane(shape.start_mm, shape.normal_axis);
  ArcSweep sweep;
  sweep.from_centre_mm = start_mm - centre_mm;
  sweep.chord_mm = in_plane(shape.end_mm, shape.normal_axis) - start_mm;
  sweep.start_radius_mm = sweep.from_centre_mm.norm();
  sweep.end_radius_mm = (in_plane(shape.end_mm, shape.normal_axis) - centre_mm).norm();
  if (!(sweep.start_radius_mm > 0.0) || !(sweep.end_radius_mm > 0.0)) {
    return error("the arc has no radius: its centre is its " +
                 std::string(sweep.start_radius_mm > 0.0 ? "end " : "start ") +
                 to_text(sweep.start_radius_mm > 0.0 ? shape.end_mm : shape.start_mm));
  }
  sweep.angle_rad = swept_angle_rad(sweep, shape.clockwise) +
                    kFullTurn_rad * static_cast<double>(shape.turns - 1);
  const std::size_t normal = axis(shape.normal_axis);
  sweep.rise_mm = shape.end_mm[normal] - shape.start_mm[normal];
  return sweep;
}

tl::expected<Arc, CurveError> Arc::make(const ArcShape& shape) {
  auto swept = sweep_of(shape);
  if (!swept) {
    return tl::unexpected(swept.error());
  }
  ArcSweep& sweep = *swept;
  const double rounding_mm =
      8.0 * std::numeric_limits<double>::epsilon() * largest_coordinate_mm(shape);
  if (std::abs(sweep.start_radius_mm - sweep.end_radius_mm) > kRadiusTolerance_mm + rounding_mm) {
    return error("the arc's radius is " + to_text(sweep.start_radius_mm) + " mm at its start and " +
                 to_text(sweep.end_radius_mm) + " mm at its end");
  }
  // What is left of a difference goes by moving the centre onto the chord's bisector, where that is
  // a small move: the circle then meets both ends to rounding.
  const double chord_mm = sweep.chord_mm.norm();
  if (chord_mm > kClosedChord_mm) {
    const Eigen::Vector2d along = sweep.chord_mm / chord_mm;
    const double off_mm = along.dot(sweep.from_centre_mm) + 0.5 * chord_mm;
    if (std::abs(off_mm) < 0.25 * sweep.start_radius_mm &&
        (std::abs(off_mm) <= kRadiusTolerance_mm || sweep.angle_rad <= std::numbers::pi)) {
      sweep.from_centre_mm -= off_mm * along;
      sweep.angle_rad = swept_angle_rad(sweep, shape.clockwise) +
                        kFullTurn_rad * static_cast<double>(shape.turns - 1);
    }
  }
  const double radius_mm = sweep.from_centre_mm.norm();
  const double in_plane_mm = radius_mm * sweep.angle_rad;
  Arc arc;
  arc.start_mm_ = shape.start_mm;
  arc.end_mm_ = shape.end_mm;
  arc.outward_mm_ = {sweep.from_centre_mm.x(), sweep.from_centre_mm.y()};
  const double sense = shape.clockwise ? -1.0 : 1.0;
  arc.forward_mm_ = {-sense * sweep.from_centre_mm.y(), sense * sweep.from_centre_mm.x()};
  arc.radius_mm_ = radius_mm;
  arc.length_mm_ = std::hypot(in_plane_mm, sweep.rise_mm);
  arc.rad_per_mm_ = sweep.angle_rad / arc.length_mm_;
  arc.in_plane_share_ = in_plane_mm / arc.length_mm_;
  arc.normal_share_ = sweep.rise_mm / arc.length_mm_;
  arc.normal_axis_ = static_cast<std::int8_t>(shape.normal_axis);
  arc.first_axis_ = static_cast<std::int8_t>((shape.normal_axis + 1) % 3);
  arc.second_axis_ = static_cast<std::int8_t>((shape.normal_axis + 2) % 3);
  return arc;
}

Arc Arc::part(const Stretch& stretch) const noexcept {
  assert(0.0 <= stretch.begin_mm && stretch.begin_mm < stretch.end_mm);
  assert(stretch.end_mm <= length_mm_);
  Arc arc = *this;
  arc.start_mm_ = at(stretch.begin_mm);
  arc.end_mm_ = at(stretch.end_mm);
  arc.length_mm_ = stretch.end_mm - stretch.begin_mm;
  const double turned_rad = rad_per_mm_ * stretch.begin_mm;
  const double cosine = std::cos(turned_rad);
  const double sine = std::sin(turned_rad);
  for (std::size_t i = 0; i < 2; ++i) {
    arc.outward_mm_[i] = cosine * outward_mm_[i] + sine * forward_mm_[i];
    arc.forward_mm_[i] = cosine * forward_mm_[i] - sine * outward_mm_[i];
  }
  return arc;
}

Position Arc::at(double s_mm) const noexcept {
  if (s_mm >= length_mm_) {
    return end_mm_;
  }
  if (!(s_mm > 0.0)) {
    return start_mm_;
  }
  // By the half angle: start + out (cos - 1) + forward sin, exact however large the radius.
  const double half_rad = 0.5 * rad_per_mm_ * s_mm;
  const double sine = std::sin(half_rad);
  const double cosine = std::cos(half_rad);
  Position p_mm = start_mm_;
  p_mm[axis(first_axis_)] += 2.0 * sine * (cosine * forward_mm_[0] - sine * outward_mm_[0]);
  p_mm[axis(second_axis_)] += 2.0 * sine * (cosine * forward_mm_[1] - sine * outward_mm_[1]);
  p_mm[axis(normal_axis_)] += normal_share_ * s_mm;
  return p_mm;
}

PathDerivatives Arc::derivatives_at(double s_mm) const noexcept {
  PathDerivatives d;
  d.position_mm = at(s_mm);
  const double clamped_mm = s_mm >= length_mm_ ? length_mm_ : (s_mm > 0.0 ? s_mm : 0.0);
  const double angle_rad = rad_per_mm_ * clamped_mm;
  const double sine = std::sin(angle_rad);
  const double cosine = std::cos(angle_rad);
  const double rate = rad_per_mm_;
  const std::array<std::size_t, 2> axes{axis(first_axis_), axis(second_axis_)};
  for (std::size_t i = 0; i < 2; ++i) {
    const double out_mm = cosine * outward_mm_[i] + sine * forward_mm_[i];
    const double forward_mm = cosine * forward_mm_[i] - sine * outward_mm_[i];
    d.first[axes[i]] = rate * forward_mm;
    d.second_per_mm[axes[i]] = -rate * rate * out_mm;
    d.third_per_mm2[axes[i]] = -rate * rate * rate * forward_mm;
  }
  d.first[axis(normal_axis_)] = normal_share_;
  return d;
}

Extents Arc::extents() const noexcept {
  Extents box;
  for (std::size_t k = 0; k < 3; ++k) {
    box.min_mm[k] = std::min(start_mm_[k], end_mm_[k]);
    box.max_mm[k] = std::max(start_mm_[k], end_mm_[k]);
  }
  const double angle_rad = rad_per_mm_ * length_mm_;
  const std::array<std::size_t, 2> axes{axis(first_axis_), axis(second_axis_)};
  for (std::size_t i = 0; i < 2; ++i) {
    const double centre_mm = start_mm_[axes[i]] - outward_mm_[i];
    for (const double side : {1.0, -1.0}) {
      // The angle, in the sense of travel, to the circle's outermost point on this side.
      double to_rad = std::atan2(side * forward_mm_[i], side * outward_mm_[i]);
      if (to_rad < 0.0) {
        to_rad += kFullTurn_rad;
      }
      if (to_rad >= angle_rad) {
        continue;
      }
      const double edge_mm = centre_mm + side * radius_mm_;
      box.min_mm[axes[i]] = std::min(box.min_mm[axes[i]], edge_mm);
      box.max_mm[axes[i]] = std::max(box.max_mm[axes[i]], edge_mm);
    }
  }
  return box;
}

}  // namespace kerf::curves
