// Lines whose time optimum is known in closed form.
#pragma once

#include "lookahead/path/block.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

struct LineJunctions {
  Junction begin{};
  Junction end{};
};

// A line that is long enough to pass both junctions as fast as they allow and to be clearly faster
// between them, or as fast as the line allows. Then no plan before or after it reaches it: at both
// junctions the feedrate has a minimum, so there is no acceleration, and between them the S-curve
// is the time optimum. Weakness: beside a junction the S-curve keeps the feedrate constant for
// three ticks, the optimum only nearly so. False for curves.
bool is_independent_line(const Block& block, const LineJunctions& junctions);

}  // namespace kerf::lookahead
