#include "lookahead/path/block_limits.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <vector>

#include "lookahead/path/normal_limits.hpp"

namespace kerf::lookahead {

namespace {

// Of an axis' limits on an arc: the shares given to centripetal acceleration, to the jerk of
// curvature at constant feedrate and to the jerk of accelerating in the turn. Squares add up across
// and along, so the rest of acceleration is 0.6 and of jerk 0.8 - 0.3 on a circle. A full circle
// runs at 0.89 of the feedrate that acceleration alone would allow.
constexpr double kCentripetalShare = 0.8;
constexpr double kCurvatureJerkShare = 0.3;
constexpr double kCrossJerkShare = 0.6;

double square(double x) {
  return x * x;
}

// The lower one stays; of two alike the first.
void bind(double& value, Constraint& from, const Bound& bound) {
  if (bound.value < value) {
    value = bound.value;
    from = bound.from;
  }
}

void bind_acceleration(BlockLimits& block, const Bound& bound) {
  bind(block.ramp.acceleration_mm_s2, block.from.acceleration, bound);
}
void bind_jerk(BlockLimits& block, const Bound& bound) {
  bind(block.ramp.jerk_mm_s3, block.from.jerk, bound);
}

BlockLimits along_path(double feedrate_mm_s, const MotionLimits& path) {
  BlockLimits block{
      .feedrate_mm_s = feedrate_mm_s,
      .ramp = {.acceleration_mm_s2 = path.acceleration_mm_s2, .jerk_mm_s3 = path.jerk_mm_s3}};
  bind_feedrate(block, {path.velocity_mm_s, Constraint::path_velocity});
  return block;
}

// number: of the axis, in XYZABCUVW. share: of the way along the path, 0: it does not move.
struct AxisShare {
  std::size_t number = 0;
  double share = 0.0;
};

void bind_share(BlockLimits& block, const MotionLimits& axis, const AxisShare& part) {
  if (part.share > 0.0) {
    const double inverse = 1.0 / part.share;
    const auto from = [&part](Constraint first) { return interp::of_axis(first, part.number); };
    bind_feedrate(block, {axis.velocity_mm_s * inverse, from(Constraint::x_velocity)});
    bind_acceleration(block, {axis.acceleration_mm_s2 * inverse, from(Constraint::x_acceleration)});
    bind_jerk(block, {axis.jerk_mm_s3 * inverse, from(Constraint::x_jerk)});
  }
}

// The weaker of two axes in each limit, and whose it is.
struct WeakestAxis {
  MotionLimits limits{};
  LimitOrigins from{};
};

WeakestAxis weakest_of(const std::vector<std::size_t>& axes, const PlanLimits& limits) {
  WeakestAxis weakest;
  for (const std::size_t k : axes) {
    const MotionLimits& axis = limits.axes[k];
    const auto from = [k](Constraint first) { return interp::of_axis(first, k); };
    bind(weakest.limits.velocity_mm_s, weakest.from.feedrate,
         {axis.velocity_mm_s, from(Constraint::x_velocity)});
    bind(weakest.limits.acceleration_mm_s2, weakest.from.acceleration,
         {axis.acceleration_mm_s2, from(Constraint::x_acceleration)});
    bind(weakest.limits.jerk_mm_s3, weakest.from.jerk, {axis.jerk_mm_s3, from(Constraint::x_jerk)});
  }
  return weakest;
}

// The feedrate at which one tick's chord leaves an arc of radius_mm by the tolerance
// (docs/math.md, 4.1): the tick spans 2 sqrt(2 r d - d^2) in the plane, at the most the diameter.
double chord_feedrate_mm_s(double radius_mm, const PlanLimits& limits) {
  const double d = std::min(limits.chord_tolerance_mm, radius_mm);
  return 2.0 / limits.period_s * std::sqrt(2.0 * radius_mm * d - d * d);
}

}  // namespace

void bind_feedrate(BlockLimits& block, const Bound& bound) {
  bind(block.feedrate_mm_s, block.from.feedrate, bound);
}

BlockLimits path_limits(double feedrate_mm_s, const PlanLimits& limits) {
  return along_path(feedrate_mm_s, limits.path);
}

BlockLimits line_limits(const curves::Line& line, double feedrate_mm_s, const PlanLimits& limits) {
  BlockLimits block = along_path(feedrate_mm_s, limits.path);
  for (std::size_t k = 0; k < 3; ++k) {
    bind_share(block, limits.axes[k], {k, std::abs(line.direction()[k])});
  }
  return block;
}

void bind_extra(const curves::AuxiliaryAxisMotion& extra, const PlanLimits& limits,
                BlockLimits& block) {
  for (std::size_t k = 0; k < curves::kAuxiliaryAxes; ++k) {
    bind_share(block, limits.extra[k], {limits.axes.size() + k, std::abs(extra.slope_per_mm(k))});
  }
}

Bend bend_of(const curves::Arc& arc) {
  const double c = arc.in_plane_share();
  const double r = arc.radius_mm();
  return {.normal_axis = arc.normal_axis(),
          .in_plane_share = c,
          .normal_share = arc.normal_share(),
          .curvature_per_mm = c * c / r,
          .third_per_mm2 = c * c * c / (r * r)};
}

Bend bend_of(const curves::NurbsCurve& spiral, int normal_axis) {
  constexpr int kSamples = 16;  // of each piece, which covers a small angle
  constexpr double kMargin = 1.02;
  const auto normal = static_cast<std::size_t>(normal_axis);
  Bend bend{.normal_axis = normal_axis, .in_plane_share = 0.0, .third_along_tangent = false};
  for (const curves::NurbsPiece& piece : spiral.pieces()) {
    for (int k = 0; k <= kSamples; ++k) {
      const double s = piece.s_begin_mm + (piece.s_end_mm - piece.s_begin_mm) * k / kSamples;
      const curves::PathDerivatives path = piece.derivatives_at(s);
      const double n = path.first[normal];
      bend.normal_share = std::max(bend.normal_share, std::abs(n));
      bend.in_plane_share = std::max(bend.in_plane_share, std::sqrt(std::max(1.0 - n * n, 0.0)));
      bend.curvature_per_mm =
          std::max(bend.curvature_per_mm, kMargin * curves::vec(path.second_per_mm).norm());
      bend.third_per_mm2 =
          std::max(bend.third_per_mm2, kMargin * curves::vec(path.third_per_mm2).norm());
    }
  }
  return bend;
}

double arc_chord_feedrate_mm_s(const Bend& bend, const PlanLimits& limits) {
  const double c = bend.in_plane_share;
  return chord_feedrate_mm_s(c * c / bend.curvature_per_mm, limits) / c;
}

BlockLimits arc_limits(const Bend& bend, double feedrate_mm_s, const PlanLimits& limits) {
  BlockLimits block = along_path(feedrate_mm_s, limits.path);
  const auto normal = static_cast<std::size_t>(bend.normal_axis);
  bind_share(block, limits.axes[normal], {normal, std::abs(bend.normal_share)});

  const auto [axis, from] = weakest_of({(normal + 1) % 3, (normal + 2) % 3}, limits);
  const double c = bend.in_plane_share;
  const double curvature = bend.curvature_per_mm;
  bind_feedrate(block, {axis.velocity_mm_s / c, from.feedrate});
  bind_feedrate(block, {arc_chord_feedrate_mm_s(bend, limits), Constraint::chord_error});
  bind_feedrate(block, normal_bound(curvature, limits));
  bind_feedrate(block, {std::sqrt(kCentripetalShare * axis.acceleration_mm_s2 / curvature),
                        from.acceleration});
  bind_feedrate(block,
                {std::cbrt(kCurvatureJerkShare * axis.jerk_mm_s3 / bend.third_per_mm2), from.jerk});

  const double v = block.feedrate_mm_s;
  if (std::isfinite(axis.acceleration_mm_s2)) {
    const double across = curvature * v * v;
    bind_acceleration(block, {std::sqrt(square(axis.acceleration_mm_s2) - square(across)) / c,
                              from.acceleration});
  }
  if (std::isfinite(axis.jerk_mm_s3)) {
    const double j = axis.jerk_mm_s3;
    bind_acceleration(block, {kCrossJerkShare * j / (3.0 * curvature * v), from.jerk});
    const double a = block.ramp.acceleration_mm_s2;
    const double across = 3.0 * curvature * v * a;
    const double from_curvature = bend.third_per_mm2 * v * v * v;
    const double along = bend.third_along_tangent
                             ? std::sqrt(square(j) - square(across)) - from_curvature
                             : std::sqrt(square(j - from_curvature) - square(across));
    bind_jerk(block, {along / c, from.jerk});
  }
  return block;
}

BlockLimits nurbs_limits(const curves::NurbsCurve& curve, double feedrate_mm_s,
                         const PlanLimits& limits) {
  constexpr double kRests_mm = 1e-9;  // what is less is rounding
  const curves::Extents box = curve.extents();
  std::vector<std::size_t> moved;
  for (std::size_t k = 0; k < limits.axes.size(); ++k) {
    if (box.max_mm[k] - box.min_mm[k] > kRests_mm) {
      moved.push_back(k);
    }
  }
  double fastest_squared = 0.0;  // of all axes at once
  for (const std::size_t k : moved) {
    fastest_squared += square(limits.axes[k].velocity_mm_s);
  }
  BlockLimits block = along_path(feedrate_mm_s, limits.path);
  const auto [weakest, from] = weakest_of(moved, limits);
  if (!moved.empty()) {
    bind_feedrate(block, {std::sqrt(fastest_squared), from.feedrate});
  }
  bind_acceleration(block, {weakest.acceleration_mm_s2, from.acceleration});
  bind_jerk(block, {weakest.jerk_mm_s3, from.jerk});
  return block;
}

}  // namespace kerf::lookahead
