// A bound of the way to rest, by steps in time: what the search's ways are held against.
#pragma once

#include <string>
#include <vector>

#include <kerf/machine.hpp>

#include "tests/kernel/planned_path.hpp"

namespace kerf::bench {

struct PathState {
  double s_mm = 0.0;  // path length
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;
};

// A bound of the way to rest. At each step the lowest jerk that all axes bear at the place, down to
// the lowest acceleration that they bear; from where the highest jerk brings the motion to rest,
// that. Optimistic where that works: jumps of direction and curvature cost nothing. It is no bound
// where the lowest jerk leads to a place at which no jerk keeps all limits: there the path's own
// counts, and the motion may go on for long. bench/optima/shortest_stops finds those that are.
double shortest_stop_mm(const test::PlannedPath& path, const PathState& from,
                        const MachineLimits& limits);

// For bench/optima/shortest_stops, into a file: the motion in which a way begins and the way; the
// accelerations at its ticks; then, over half as much again, rows of distance and for each axis the
// path's three derivatives by s.
struct WayToRest {
  PathState from{};
  double way_mm = 0.0;
  std::vector<double> a_mm_s2{};  // at its ticks, of `from` on
};
void write_way(const std::string& file, const test::PlannedPath& path, const WayToRest& way);

}  // namespace kerf::bench
