// A point or a vector in space, and the bridge to Eigen.
//
// Eigen::Vector3d is not trivially copyable (Eigen 3.4), so whatever crosses to the tick side stores
// std::array and computes through Eigen::Map.
#pragma once

#include <array>

#include <Eigen/Core>

namespace kerf::curves {

using Position = std::array<double, 3>;  // x, y, z

inline Eigen::Map<const Eigen::Vector3d> vec(const Position& p) noexcept {
  return Eigen::Map<const Eigen::Vector3d>(p.data());
}

inline Position to_position(const Eigen::Vector3d& v) noexcept { return {v.x(), v.y(), v.z()}; }

// Position and its derivatives by arc length: first is the unit tangent, |second| the curvature.
struct PathDerivatives {
  Position position_mm{};
  Position first{};
  Position second_per_mm{};
  Position third_per_mm2{};
};

// The box that a path fills.
struct Extents {
  Position min_mm{};
  Position max_mm{};
};

}  // namespace kerf::curves
