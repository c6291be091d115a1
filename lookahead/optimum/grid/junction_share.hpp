// Shares the axes' limits between a jump of direction or curvature and the motion around it.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

// A third difference of positions that sees a jump adds up three things, each of which gets its
// share of the jerk: the jump at constant feedrate (junction.hpp), the acceleration along the path,
// which turns with the direction (3/4 a |du| / Ts), and the jerk of the cells within a distance of
// three ticks. A jump that hardly counts at the allowed feedrate takes little, and the tool keeps
// accelerating over it; one that bounds the feedrate takes nearly all, since the motion beside it
// is almost a cruise then.
struct JumpShares {
  double jump = 0.0;
  double turn = 0.0;
  double cells = 1.0;
  // Share of the acceleration along the path that the cells may use.
  double tangential = 1.0;
};

// Limits of the motion at a place where direction or curvature jumps.
//
// Where curvature alone jumps, an axis' acceleration steps by |dk| v^2, and a third difference of
// positions sees 3/4 |dk| v^2 / Ts of it at the most. That is a form over v^2 like any other limit
// of the cells around it, so no share is fixed: jerk of the cell + jumps v^2 <= J.
struct JunctionLimits {
  double feedrate_mm_s = kUnbounded;
  double acceleration_mm_s2 = kUnbounded;  // along the path
  JumpShares shares{};
  // Share of the axes' acceleration that the jump leaves to the cells.
  double acceleration_share = 1.0;
  curves::Position jumps_per_mm_s{};  // Cell::jumps_per_mm_s; 0: the shares say what the jump takes
};

// A jump at a place within a curve.
struct Jump {
  BlockEnd before{};
  BlockEnd after{};
  double allowed_mm_s = kUnbounded;  // the feedrate by all other limits
  // How many jumps a third difference that sees this one may see, itself included.
  int crowd = 1;
};

// The jump gets the least shares with which the allowed feedrate can be kept.
JunctionLimits junction_limits_of(const Jump& jump, const PlanLimits& limits);

// How a junction may be passed; by default a stop.
struct CellJunction {
  bool smooth = false;  // nothing jumps there
  JunctionLimits limits{.feedrate_mm_s = 0.0};

  [[nodiscard]] bool is_stop() const noexcept { return limits.feedrate_mm_s == 0.0; }
};

CellJunction cell_junction_of(const JunctionQuery& query, const PlanLimits& limits);
// One that the motion has just passed at about this feedrate, whatever a plan of now would do
// there: ticks still see its jump.
CellJunction passed_junction_of(const JunctionQuery& query, double v_mm_s,
                                const PlanLimits& limits);

// Whether a junction passed at this feedrate takes so much of the limits that the motion beside it
// is a cruise.
bool passed_as_cruise(const JunctionQuery& query, double feedrate_mm_s, const PlanLimits& limits);

// The distance of three ticks from a jump, at the most. cell, end: beside it.
double zone_mm(const Cell& cell, const curves::PathDerivatives& end, const JunctionLimits& junction,
               const PlanLimits& limits);

// Gives the cells near a junction what they have where the motion rests at it: no jump is passed
// there. side: of the block, the junction's.
void relax_beside_rest(std::vector<Cell>& cells, BlockSide side);
// What the cell has where the junction is passed in motion.
void bind_beside_junction(Cell& cell);

// Caps feedrate and acceleration at a boundary of cells, the one before cells[boundary] (0 and the
// count of cells are the ends), and leaves the cells around it their share.
void share_limits(std::vector<Cell>& cells, std::size_t boundary, const JunctionLimits& junction,
                  const PlanLimits& limits);

}  // namespace kerf::lookahead
