// How a place where direction or curvature jumps shares the axes' limits with the motion around it.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

// A third difference of positions that sees a jump adds up three things, each of which gets its
// share of the jerk: the jump at constant feedrate (junction.hpp), the acceleration along the path,
// which turns with the direction (3/4 a |du| / Ts), and what the cells within three ticks' way ask
// for. A jump that hardly counts at the feedrate that is allowed anyway takes little, and the tool
// goes on accelerating over it; one that bounds the feedrate takes nearly all, for the motion
// beside it is almost a cruise then.
struct JumpShares {
  double jump = 0.0;
  double turn = 0.0;
  double cells = 1.0;
  // Of the acceleration along the path that there would be: the cells may use that much of it.
  double tangential = 1.0;
};

// The limits with the share of the jump itself.
PlanLimits jump_limits(const PlanLimits& limits, const JumpShares& shares);

// What the motion may be at a place where direction or curvature jumps.
struct JunctionLimits {
  double feedrate_mm_s = kUnbounded;
  double acceleration_mm_s2 = kUnbounded;  // along the path
  JumpShares shares{};
  // What of the axes' acceleration the jump leaves to the cells.
  double acceleration_share = 1.0;
};

// What jumps at a place within a curve.
struct Jump {
  BlockEnd before{};
  BlockEnd after{};
  double allowed_mm_s = kUnbounded;  // by anything else
  // How many jumps a third difference that sees this one may see, itself included.
  int crowd = 1;
};

// With the least shares of the jump at which the allowed feedrate can be kept.
JunctionLimits junction_limits_of(const Jump& jump, const PlanLimits& limits);

// How a junction may be passed; a stop, unless said otherwise.
struct CellJunction {
  bool smooth = false;  // nothing jumps there
  JunctionLimits limits{.feedrate_mm_s = 0.0};

  [[nodiscard]] bool is_stop() const noexcept { return limits.feedrate_mm_s == 0.0; }
};

CellJunction cell_junction_of(const JunctionQuery& query, const PlanLimits& limits);

// The way of three ticks from a jump, at the most. cell, end: beside it.
double zone_mm(const Cell& cell, const curves::PathDerivatives& end, const JunctionLimits& junction,
               const PlanLimits& limits);

// Caps feedrate and acceleration at a boundary of cells, the one before cells[boundary] (0 and the
// count of cells are the ends), and leaves the cells around it their share.
void share_limits(std::vector<Cell>& cells, std::size_t boundary, const JunctionLimits& junction,
                  const PlanLimits& limits);

}  // namespace kerf::lookahead
