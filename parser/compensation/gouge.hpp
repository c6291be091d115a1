// Whether the tool on its way past one move cuts into the contour of another.
#pragma once

#include "parser/compensation/held_move.hpp"

namespace kerf::parser {

// How deep the tool on `mover`'s way, corner included, cuts into `contour`; 0 where it does not,
// and where the two cannot be compared: other runs, other depths, no contour. Rounding and what an
// arc's two radii differ by do not count. The nick that every straight entry and exit makes in the
// contour's first and last point (see gouge.cpp) does not count either.
double depth_of_cut_mm(const HeldMove& mover, const HeldMove& contour, double radius_mm);

// Whether one move begins or ends on the contour of another, and whether it ends where it begins.
bool starts_on(const HeldMove& move, const HeldMove& other);
bool ends_on(const HeldMove& move, const HeldMove& other);
bool is_closed(const HeldMove& move);

// Whether the two meet where a closed contour begins and ends. There is no corner in the program's
// order, so LinuxCNC (and Kerf) do nothing about it: at an inside corner each of them ends or
// begins inside the other.
bool meet_at_seam(const HeldMove& mover, const HeldMove& contour);

}  // namespace kerf::parser
