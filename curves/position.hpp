// A point or a vector in space, and the bridge to Eigen.
//
// Eigen::Vector3d is not trivially copyable (Eigen 3.4), so whatever crosses to the tick side
// stores std::array and computes through Eigen::Map.
#pragma once

#include <cmath>

#include <Eigen/Core>
#include <kerf/axes.hpp>

namespace kerf::curves {

using kerf::Extents;
using kerf::Position;

// Coordinates beyond this (or not finite) are refused: at 1e9 mm a double resolves only 1e-7 mm.
inline constexpr double kMaxCoordinate_mm = 1e9;

inline bool is_usable(double coordinate_mm) noexcept {
  return std::abs(coordinate_mm) <= kMaxCoordinate_mm;  // false for NaN
}

inline bool is_usable(const Position& p_mm) noexcept {
  return is_usable(p_mm[0]) && is_usable(p_mm[1]) && is_usable(p_mm[2]);
}

inline Eigen::Map<const Eigen::Vector3d> vec(const Position& p) noexcept {
  return Eigen::Map<const Eigen::Vector3d>(p.data());
}

inline Position to_position(const Eigen::Vector3d& v) noexcept {
  return {v.x(), v.y(), v.z()};
}

// Position and its derivatives by arc length: first is the unit tangent, |second| the curvature.
struct PathDerivatives {
  Position position_mm{};
  Position first{};
  Position second_per_mm{};
  Position third_per_mm2{};
};

// Along a curve, from its start. begin_mm < end_mm.
struct Stretch {
  double begin_mm = 0.0;
  double end_mm = 0.0;
};

}  // namespace kerf::curves
