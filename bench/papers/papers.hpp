// The published results beside ours.
#pragma once

#include <kerf/kerf.hpp>

#include "bench/papers/comparison.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::bench {

// Prints the tables as Markdown on standard output. Exit status: 0, 1 where a figure is not what
// the tables say of it, or a limit is exceeded.
int papers();

// One paper each; false where its part of that is not so.
bool sigmoid_butterfly();
bool sigmoid_wm();
bool sine_series();
bool quintic();

// The rows of the contour errors of [SineSeries], of a butterfly and of a trident.
void add_contour_errors(const MachineSettings& settings, Comparison& table);

// Its critical points of curvature, and the times of its method over them.
void add_critical_points(const lookahead::PlanLimits& limits, Comparison& table);
void print_over_critical_points(const lookahead::PlanLimits& limits);

}  // namespace kerf::bench
