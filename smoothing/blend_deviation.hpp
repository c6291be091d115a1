// How far a blend is from the corner that it rounds.
#pragma once

#include "smoothing/blend.hpp"
#include "smoothing/path_deviations.hpp"

namespace kerf::smoothing {

// The larger of how far places of the blend are from the curves and places of what it replaces from
// the blend. Its line is not set.
PathDeviation deviation_of(const Blend& blend, const Corner& corner, double way_mm);

}  // namespace kerf::smoothing
