// How A, B, C, U, V and W follow a curve: linearly in its length.
#pragma once

#include <cstddef>

#include <kerf/axes.hpp>

namespace kerf::curves {

using kerf::AuxiliaryExtents;
using kerf::AuxiliaryPosition;
using kerf::kAuxiliaryAxes;

struct AuxiliaryAxisMotion {
  AuxiliaryPosition begin_rad_mm{};
  AuxiliaryPosition end_rad_mm{};
  double length_mm = 0.0;  // of the curve; 0: they rest at end_rad_mm
  // True: X, Y and Z rest, and the length is that of this motion, in rad if only A, B, C move.
  bool alone = false;

  // s_mm is clamped to [0, length]; both ends are exact.
  [[nodiscard]] AuxiliaryPosition at(double s_mm) const noexcept {
    if (s_mm >= length_mm) {
      return end_rad_mm;
    }
    if (!(s_mm > 0.0)) {
      return begin_rad_mm;
    }
    const double share = s_mm / length_mm;
    AuxiliaryPosition position;
    for (std::size_t k = 0; k < kAuxiliaryAxes; ++k) {
      position[k] = begin_rad_mm[k] + share * (end_rad_mm[k] - begin_rad_mm[k]);
    }
    return position;
  }
  // How far an axis moves per length of the curve.
  [[nodiscard]] double slope_per_mm(std::size_t axis) const noexcept {
    return length_mm > 0.0 ? (end_rad_mm[axis] - begin_rad_mm[axis]) / length_mm : 0.0;
  }
};

}  // namespace kerf::curves
