// The grid of the time optimum: cells of a path, each with what bounds the motion on it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// A little inside, so that what the check finds between two places is not beyond.
inline constexpr double kAim = 0.9995;

// What of the limits the solver may use in a cell: less where a check found that the limits were
// passed between the places at which it looks.
struct LimitShares {
  double feedrate = kAim;
  double acceleration = kAim;
  double jerk = kAim;
};

// What of the limits of acceleration and jerk a junction beside a cell leaves.
struct AllowedShares {
  double acceleration = 1.0;
  double jerk = 1.0;
};

struct Cell {
  std::uint64_t block = 0;  // the block it lies on
  double s_begin_mm = 0.0;  // on the block's curve
  double length_mm = 0.0;
  bool ends_block = false;  // the block's last
  bool rest_after = false;  // the motion comes to rest at its end
  // The path at its ends, seen from within: derivatives may jump from a cell to the next.
  PathSample begin{};
  PathSample end{};
  profiles::RampLimits along{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded};
  LimitOrigins along_from{};
  AllowedShares allowed{};
  double sub_tick_mm_s = kUnbounded;  // in a sub-tick zone: no faster anywhere in it
  // What the solver aims at, within what is allowed.
  LimitShares shares{};
  bool continues = false;        // the cell before it: one, but for a rest that a plan ends with
  double planned_squared = 0.0;  // v^2 in its middle in an earlier plan, mm^2/s^2; 0: none

  [[nodiscard]] double s_end_mm() const noexcept { return s_begin_mm + length_mm; }
};

// The path at s_mm of the cell's block.
using PathAt = std::function<PathSample(const Cell& cell, double s_mm)>;

// Where a sequence of cells begins; it always ends at rest. v = 0: at rest, and then a = 0.
struct StartState {
  double v_mm_s = 0.0;
  double a_mm_s2 = 0.0;

  [[nodiscard]] bool at_rest() const noexcept { return v_mm_s == 0.0; }
};

}  // namespace kerf::lookahead
