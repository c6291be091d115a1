// Whether the tool on its way past one move cuts into the contour of another.
#pragma once

#include <deque>

#include "parser/compensation/held_move.hpp"

namespace kerf::parser {

// How deep the tool on `mover`'s way, corner included, cuts into `contour`; 0 where it does not,
// and where the two cannot be compared: other runs, other depths, no contour. Rounding and what an
// arc's two radii differ by do not count. The nick that every straight entry and exit makes in the
// contour's first and last point (see gouge.cpp) does not count either.
double depth_of_cut_mm(const HeldMove& mover, const HeldMove& contour, double radius_mm);

// Whether the contour of the one leads the tool on to, or away from, a closed contour that the other
// is part of: the programmed path comes back to where the lead joins it. Such a lead is no wall, the
// contour's last pass crosses it. Looks at the neighbours of both among `held`.
bool is_lead(const std::deque<HeldMove>& held, const HeldMove& mover, const HeldMove& contour);

// Whether the two meet where a closed contour begins and ends. There is no corner in the program's
// order, so LinuxCNC (and Kerf) do nothing about it: at an inside corner each of them ends or
// begins inside the other.
bool meet_at_seam(const HeldMove& mover, const HeldMove& contour);

}  // namespace kerf::parser
