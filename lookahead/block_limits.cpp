#include "lookahead/block_limits.hpp"

#include <algorithm>
#include <cmath>

namespace kerf::lookahead {

namespace {

// Of an axis' limits on an arc: the shares given to centripetal acceleration, to the jerk of
// turning at constant feedrate and to the jerk of accelerating in the turn. Squares add up across
// and along, so the rest of acceleration is 0.6 and of jerk 0.8 - 0.3 on a circle. A full circle
// runs at 0.89 of the feedrate that acceleration alone would allow.
constexpr double kCentripetalShare = 0.8;
constexpr double kTurningJerkShare = 0.3;
constexpr double kCrossJerkShare = 0.6;

double square(double x) {
  return x * x;
}

BlockLimits along_path(double feedrate_mm_s, const MotionLimits& path) {
  return {.feedrate_mm_s = std::min(feedrate_mm_s, path.velocity_mm_s),
          .ramp = {.acceleration_mm_s2 = path.acceleration_mm_s2, .jerk_mm_s3 = path.jerk_mm_s3}};
}

void bind_share(BlockLimits& block, const MotionLimits& axis, double share) {
  if (share > 0.0) {
    const double inverse = 1.0 / share;
    block.feedrate_mm_s = std::min(block.feedrate_mm_s, axis.velocity_mm_s * inverse);
    block.ramp.acceleration_mm_s2 =
        std::min(block.ramp.acceleration_mm_s2, axis.acceleration_mm_s2 * inverse);
    block.ramp.jerk_mm_s3 = std::min(block.ramp.jerk_mm_s3, axis.jerk_mm_s3 * inverse);
  }
}

MotionLimits weaker(const MotionLimits& a, const MotionLimits& b) {
  return {.velocity_mm_s = std::min(a.velocity_mm_s, b.velocity_mm_s),
          .acceleration_mm_s2 = std::min(a.acceleration_mm_s2, b.acceleration_mm_s2),
          .jerk_mm_s3 = std::min(a.jerk_mm_s3, b.jerk_mm_s3)};
}

// The feedrate at which one tick's chord leaves an arc of radius_mm by the tolerance (MATH
// section 5): the tick spans 2 sqrt(2 r d - d^2) in the plane, at the most the diameter.
double chord_feedrate_mm_s(double radius_mm, const PlanLimits& limits) {
  const double d = std::min(limits.chord_tolerance_mm, radius_mm);
  return 2.0 / limits.period_s * std::sqrt(2.0 * radius_mm * d - d * d);
}

}  // namespace

BlockLimits path_limits(double feedrate_mm_s, const PlanLimits& limits) {
  return along_path(feedrate_mm_s, limits.path);
}

BlockLimits line_limits(const curves::Line& line, double feedrate_mm_s, const PlanLimits& limits) {
  BlockLimits block = along_path(feedrate_mm_s, limits.path);
  for (std::size_t k = 0; k < 3; ++k) {
    bind_share(block, limits.axes[k], std::abs(line.direction()[k]));
  }
  return block;
}

void bind_extra(const curves::ExtraWay& extra, const PlanLimits& limits, BlockLimits& block) {
  for (std::size_t k = 0; k < curves::kExtraAxes; ++k) {
    bind_share(block, limits.extra[k], std::abs(extra.slope_per_mm(k)));
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
  bind_share(block, limits.axes[normal], std::abs(bend.normal_share));

  const MotionLimits axis = weaker(limits.axes[(normal + 1) % 3], limits.axes[(normal + 2) % 3]);
  const double c = bend.in_plane_share;
  const double curvature = bend.curvature_per_mm;
  double& v = block.feedrate_mm_s;
  v = std::min({v, axis.velocity_mm_s / c, arc_chord_feedrate_mm_s(bend, limits),
                std::sqrt(kCentripetalShare * axis.acceleration_mm_s2 / curvature),
                std::cbrt(kTurningJerkShare * axis.jerk_mm_s3 / bend.third_per_mm2)});

  double& a = block.ramp.acceleration_mm_s2;
  if (std::isfinite(axis.acceleration_mm_s2)) {
    const double across = curvature * v * v;
    a = std::min(a, std::sqrt(square(axis.acceleration_mm_s2) - square(across)) / c);
  }
  if (std::isfinite(axis.jerk_mm_s3)) {
    const double j = axis.jerk_mm_s3;
    a = std::min(a, kCrossJerkShare * j / (3.0 * curvature * v));
    const double across = 3.0 * curvature * v * a;
    const double turning = bend.third_per_mm2 * v * v * v;
    const double along = bend.third_along_tangent ? std::sqrt(square(j) - square(across)) - turning
                                                  : std::sqrt(square(j - turning) - square(across));
    block.ramp.jerk_mm_s3 = std::min(block.ramp.jerk_mm_s3, along / c);
  }
  return block;
}

BlockLimits nurbs_limits(double feedrate_mm_s, const PlanLimits& limits) {
  const MotionLimits weakest = weaker(weaker(limits.axes[0], limits.axes[1]), limits.axes[2]);
  return along_path(feedrate_mm_s, weaker(limits.path, weakest));
}

}  // namespace kerf::lookahead
