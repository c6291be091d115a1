// What a curve that one tick may pass over whole asks of the motion beside it.
#pragma once

#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// Beside a junction: no faster over this way.
struct PassingWay {
  double feedrate_mm_s = kUnbounded;
  double way_mm = 0.0;  // 0: nothing is asked
};

// curve: it joins `beside`, at no more than v_junction_mm_s.
struct PassedCurve {
  const Block& curve;
  const BlockEnd& junction;  // of `beside`
  const Block& beside;
  double v_junction_mm_s = 0.0;
};

// The bound of the curve (passing_feedrate_mm_s) is one of a tick's mean feedrate, and a tick that
// passes over all of it may speed up away from it, or fall towards it. Over the way of a tick at
// that bound beside it the bound holds as well: a tick that sees all of the curve and leaves that
// way takes longer than a tick. Nothing is asked where the feedrate that the junction allows keeps
// the bound with all the acceleration that there is. Weakness: where `beside` is shorter than the
// way, what lies beyond it is not bound.
PassingWay passing_way(const PassedCurve& passed, const PlanLimits& limits);

struct PassingWays {
  PassingWay begin{};
  PassingWay end{};
};

// Of the cells of a block: those of the ways.
void bind_ways(const PassingWays& ways, std::vector<Cell>& cells);

}  // namespace kerf::lookahead
