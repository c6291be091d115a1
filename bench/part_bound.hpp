// The least time that a part can take, found without planning it.
#pragma once

#include "bench/part_programs.hpp"
#include "bench/part_run.hpp"

namespace kerf::bench {

// No motion is faster than F, nor where the path has radius r and direction t than the v at which
// some acceleration along it leaves every axis within a: |v^2 n / r + t a_t| <= a.
double spiral_bound_s(const SpiralShape& shape, double feed_mm_s, const AxisSet& axes);

}  // namespace kerf::bench
