// The feedrate at which the junction of two blocks may be passed.
#pragma once

#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"

namespace kerf::lookahead {

// A junction changes the direction of the path by du and its curvature vector by dk. Seen in ticks
// of Ts, passing it at feedrate F with constant speed gives an axis (docs/math.md, 7.1; the third
// difference of positions is x''' averaged with a quadratic B-spline, whose peak is 3/4 of 1/Ts)
//
//   acceleration  F |du| / Ts + F^2 max|k|            <= A
//   jerk          F |du| / Ts^2 + 3/4 F^2 |dk| / Ts + F^3 max|q'''| <= J
//   chord         F |du| Ts / 4 + F^2 max|k| Ts^2 / 8 <= tolerance
//
// (of an extra axis, which is linear in the path's length, and of the path only the terms with
// |du|), which is solved for the largest F. The last is the path's distance from the straight line
// between the ticks on both sides, as Green's function of a chord bounds it. The plan keeps the
// feedrate constant for constant_velocity_s on both sides, so that nothing else adds to it in any
// window of ticks that sees the junction.
struct Junction {
  double feedrate_mm_s = kUnbounded;  // 0: stop
  double constant_velocity_s = 0.0;   // 0 where the junction is smooth or a stop
};

struct JunctionQuery {
  const Block* before = nullptr;
  const Block* after = nullptr;
};

// An axis without a limit of its own has that of the path. A block that continues the one before
// joins it smoothly, whatever difference rounding has left.
Junction junction_of(const JunctionQuery& query, const PlanLimits& limits);

// The relative jump of the feedrate along X, Y and Z: 1 between a block on which they move and one
// on which only further axes do, else 0.
double path_step_of(const BlockEnd& before, const BlockEnd& after);

// The bound by chord error alone.
double chord_feedrate_mm_s(const BlockEnd& before, const BlockEnd& after, const PlanLimits& limits);

// The highest feedrate inside the block and at its ends. The chord scan bounds ticks whose
// middle is on the curve. The chord of a tick that passes over a whole curve cuts the corner that
// the curve rounds, and a curve shorter than a tick's distance may round any corner within the
// tolerance.
double sub_tick_feedrate_mm_s(const Block& block, const PlanLimits& limits);

// All bounds, whatever the lengths of the blocks, and without the choice to stop.
double corner_feedrate_mm_s(const BlockEnd& before, const BlockEnd& after,
                            const PlanLimits& limits);

}  // namespace kerf::lookahead
