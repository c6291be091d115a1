#pragma once

#include "curves/curve.hpp"

namespace kerf::curves {

inline double distance_mm(const Position& a, const Position& b) {
  return (vec(a) - vec(b)).norm();
}

}  // namespace kerf::curves
