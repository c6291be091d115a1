// Positions and limits of the axes.
#pragma once

#include <array>
#include <cstddef>

namespace kerf {
inline namespace v0 {

/// X, Y, Z in mm.
using Position = std::array<double, 3>;

/// A, B, C, U, V, W, in this order everywhere.
inline constexpr std::size_t kAuxiliaryAxes = 6;

/// A, B, C in rad, then U, V, W in mm.
using AuxiliaryPosition = std::array<double, kAuxiliaryAxes>;

/// The box that a path fills.
struct Extents {
  Position min_mm{};
  Position max_mm{};
};
/// The same for A, B, C in rad and U, V, W in mm.
struct AuxiliaryExtents {
  AuxiliaryPosition min_rad_mm{};
  AuxiliaryPosition max_rad_mm{};
};

/// The value of a limit that does not bind.
inline constexpr double kUnbounded = __builtin_huge_val();

/// Of one axis, or along the path; each > 0.
struct MotionLimits {
  double velocity_mm_s = kUnbounded;
  double acceleration_mm_s2 = kUnbounded;
  double jerk_mm_s3 = kUnbounded;
};

/// The limits of the motion. Each of velocity, acceleration and jerk must be bounded along the path
/// or on all of X, Y and Z, and on each auxiliary axis that the machine has.
struct MachineLimits {
  double period_s = 0.001;  ///< between two setpoints
  MotionLimits path{};
  std::array<MotionLimits, 3> axes{};
  /// A, B, C: read rad for mm in the names. They hold whatever the limits along the path are; where
  /// only these axes move, the limits along the path do not count.
  std::array<MotionLimits, kAuxiliaryAxes> extra{};
  double chord_tolerance_mm = kUnbounded;  ///< between path and chord of two setpoints, on NURBS
  /// Across the path of X, Y and Z where it is curved, at feedrate v and curvature k: k v^2, and
  /// k^2 v^3, the jerk on the circle of curvature. Corners are junctions and not bound by them.
  double normal_acceleration_mm_s2 = kUnbounded;
  double normal_jerk_mm_s3 = kUnbounded;
};

}  // namespace v0
}  // namespace kerf
