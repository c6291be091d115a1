// How far the commanded path is from the programmed one.
#pragma once

#include <kerf/report.hpp>

namespace kerf::smoothing {

using kerf::PathDeviation;

inline PathDeviation larger(const PathDeviation& a, const PathDeviation& b) {
  return b.distance_mm > a.distance_mm ? b : a;
}

// Of many places.
struct PathDeviations {
  PathDeviation largest;
  PathDeviation worst;  // the farthest beyond its tolerance; distance 0 where none is

  void add(const PathDeviation& deviation) {
    largest = larger(largest, deviation);
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
