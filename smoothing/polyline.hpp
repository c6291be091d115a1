// The points of a run of short lines, and its corners.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "curves/position.hpp"
#include "parser/moves/move.hpp"

namespace kerf::smoothing {

struct Vertex {
  curves::Position point_mm{};
  double w_mm = 0.0;  // length of the run up to here
  // Of the line that ends here.
  double feedrate_mm_s = 0.0;
  parser::FollowedOverrides follows{};
  diagnostics::SourcePosition source{};
  std::uint64_t run_block = 0;
};

// Of the lines that end there.
inline bool is_of_one_feedrate(const Vertex& a, const Vertex& b) {
  return a.feedrate_mm_s == b.feedrate_mm_s && a.follows == b.follows;
}

using Polyline = std::vector<Vertex>;

// Between two directions of any length, 0 to pi.
double turn_rad(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

// A place where the program means a corner, seen from the lines around it. Precondition: it is
// neither the first nor the last vertex. tolerance_mm: of merging, > 0.
//
// Lines that stand for a smooth curve turn by little, and each by about as much as its neighbours.
// So it is a corner
// - where two lines turn by more than a curve within the tolerance of both could follow: the
//   curve's height over a chord is length times turn / 8;
// - where the run turns, within a few tolerances, by much more than before and after. The lengths
//   over which directions are taken are about the tolerance, since noise in the last decimal turns
//   very short lines by any angle;
// - where a long line meets a short one: it was not meant to be part of the curve.
bool is_corner(const Polyline& run, std::size_t index, double tolerance_mm);

// All vertices up to the last are as good as on a line, in order: within rounding, or bent by less
// than a circle of 100 m and well within the tolerance.
bool is_straight(const Polyline& run, std::size_t last, double tolerance_mm);

}  // namespace kerf::smoothing
