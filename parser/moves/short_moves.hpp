// Moves that are too short to be run.
#pragma once

#include <array>

#include "parser/moves/auxiliary_axes.hpp"
#include "parser/moves/move.hpp"

namespace kerf::parser {

// Where a move leads X, Y and Z; null for a dwell or an event.
const Point* end_mm(const Move& move);
// The length of the way that a move programs for X, Y and Z; of a curve an upper bound.
double way_mm(const Move& move);

// Leaves out moves that are too short, so that no curve is built of them, and loses nothing by it:
// the tool stays where it is, and the next move that is long enough starts there. A curve starts
// there as a whole, shifted by less than kShortestWay_mm, because its shape depends on its ends; a
// line then ends where the program says. So the tool is never farther than kShortestWay_mm from
// where the program is, however many short moves follow each other.
//
// Of a curve that is too short only the way to its end is left. Where X, Y and Z are too short and
// an auxiliary axis is not, the auxiliary axes move alone, in the time that the feedrate asks for.
class ShortMoves {
 public:
  // False: the move is left out. Moves come in the order of the program.
  bool take(Move& move);
  // The last move has ended there, which the program could not know.
  void end_at(const Point& place_mm) { place_mm_ = place_mm; }

 private:
  void begin_at_place(Move& move);

  Point place_mm_{};                  // of the tool
  AuxiliaryPosition place_rad_mm_{};  // of the auxiliary axes
  bool behind_ = false;  // they may not be where the program is; else neither place is in use
};

}  // namespace kerf::parser
