// The grid of the time optimum: cells of a path, each with the limits of the motion on it.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "lookahead/path/path_sample.hpp"

namespace kerf::lookahead {

// The solver aims a little inside the limits, so that the check between two places finds no excess.
inline constexpr double kAim = 0.9995;
// The feedrate where its bound is constant over a cell: a cruise is at the feedrate itself.
inline constexpr double kAimOfCruise = 1.0 - 1e-7;

// The share of the limits that the solver may use in a cell: less where a check found the limits
// exceeded between the places at which the solver evaluates them.
struct LimitShares {
  double feedrate = kAim;
  double acceleration = kAim;
  double jerk = kAim;
};

// The share of the limits of acceleration and jerk that a junction leaves to the cell beside it.
struct AllowedShares {
  double acceleration = 1.0;
  double jerk = 1.0;
};

// The limits of a cell that a junction at an end of its block lowers.
struct LoweredLimits {
  AllowedShares allowed{};
  double acceleration_mm_s2 = kUnbounded;  // along the path
  curves::Position jumps_per_mm_s{};       // Cell::jumps_per_mm_s
};

enum class BlockSide : std::uint8_t { none, begin, end };

struct Cell {
  std::uint64_t block = 0;  // the block it lies on
  double s_begin_mm = 0.0;  // on the block's curve
  double length_mm = 0.0;
  bool ends_block = false;  // the block's last
  bool rest_after = false;  // the motion comes to rest at its end
  // The path at its ends, seen from within: derivatives may jump from a cell to the next.
  PathSample begin{};
  PathSample end{};
  bool straight = false;  // of a line: the path's derivatives are the same all along it
  profiles::RampLimits along{.acceleration_mm_s2 = kUnbounded, .jerk_mm_s3 = kUnbounded};
  LimitOrigins along_from{};
  AllowedShares allowed{};
  // Jumps of curvature that one third difference sees together with the cell add jerk to each axis,
  // in mm/s^3 per v^2 at the most (junction_share.hpp).
  curves::Position jumps_per_mm_s{};
  double sub_tick_mm_s = kUnbounded;  // the highest feedrate in it, if it lies in a sub-tick zone
  // Near a junction at this side of the block: what the cell has instead where the motion rests at
  // the junction (relax_beside_rest).
  BlockSide beside = BlockSide::none;
  bool relaxed = false;  // and has now: then these are what it has in motion
  LoweredLimits instead{};
  // The solver aims at these, within `allowed`.
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
