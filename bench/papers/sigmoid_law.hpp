// Peaks of a feedrate law, as it has them and as [Sigmoid] bounds them.
#pragma once

#include "profiles/feedrate_shape.hpp"
#include "profiles/profile.hpp"

namespace kerf::bench {

// From how long a change of feedrate takes.
profiles::ShapePeaks peaks_of(const profiles::Profile& profile);

// [Sigmoid, equations 60 to 62]: the largest of the three, a quarter of its bound of j*.
double paper_bound_of_jerk(double shape);

}  // namespace kerf::bench
