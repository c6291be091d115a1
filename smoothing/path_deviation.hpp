// How far the commanded path is from the programmed one.
#pragma once

#include <cstdint>

#include "curves/position.hpp"

namespace kerf::smoothing {

// The largest distance, either way round, and the place of the commanded path where it is.
struct PathDeviation {
  double distance_mm = 0.0;
  curves::Position at_mm{};
  std::uint32_t line = 0;
  double tolerance_mm = 0.0;  // P or Q in force there

  void widen(const PathDeviation& other) {
    if (other.distance_mm > distance_mm) {
      *this = other;
    }
  }
};

// Of many places.
struct PathDeviations {
  PathDeviation largest;
  PathDeviation worst;  // the farthest beyond its tolerance; of no distance where none is

  void add(const PathDeviation& deviation) {
    largest.widen(deviation);
    if (deviation.distance_mm - deviation.tolerance_mm > worst.distance_mm - worst.tolerance_mm) {
      worst = deviation;
    }
  }
  void add(const PathDeviations& other) {
    add(other.largest);
    add(other.worst);
  }
};

}  // namespace kerf::smoothing
