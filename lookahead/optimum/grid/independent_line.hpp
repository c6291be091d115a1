// Lines whose time optimum is known in closed form.
#pragma once

#include "lookahead/path/block.hpp"
#include "lookahead/path/junction.hpp"

namespace kerf::lookahead {

struct LineJunctions {
  Junction begin{};
  Junction end{};
  bool are_cruises = false;  // both are a rest, or passed_as_cruise (junction_share.hpp)
};

// A line that is long enough to pass both junctions as fast as they allow, with no acceleration at
// either: then no plan before or after it reaches it, and between them the S-curve is the time
// optimum. There is none at junctions that leave nothing for it; nor where the line is long enough
// to be clearly faster between them, or as fast as it allows, for then the feedrate has a minimum
// at both. Weakness: beside a junction the S-curve keeps the feedrate constant for three ticks, the
// optimum only nearly so. False for curves.
bool is_independent_line(const Block& block, const LineJunctions& junctions);

}  // namespace kerf::lookahead
