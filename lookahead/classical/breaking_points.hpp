// Where the allowed feedrate of a curve turns: the ends of its blocks.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/path/velocity_limit_curve.hpp"

namespace kerf::lookahead {

// Indices of the breaking points of a scan, first and last sample included, in two steps
// [Sigmoid, section 3.2], docs/math.md, 6.1:
// 1. screening: the slope of v over u changes by more than screening_mm_s between two samples;
// 2. of these candidates those stay where v does not go on in the same direction.
std::vector<std::size_t> breaking_points(const VelocityLimitCurve& limit_curve,
                                         double screening_mm_s);

// The breaking points that are valleys: the lowest between two hills that both rise above it by
// more than noise, a share of the feedrate.
std::vector<std::size_t> valleys(const VelocityLimitCurve& limit_curve,
                                 const std::vector<std::size_t>& breaking, double noise = 0.01);

}  // namespace kerf::lookahead
