// Where a time optimum begins that goes on from a motion.
#pragma once

#include <cstddef>
#include <vector>

#include "lookahead/optimum/grid/cell.hpp"
#include "lookahead/optimum/grid/waiting_cells.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// More cells are not planned first: the answer is urgent, and what follows is added later.
inline constexpr std::size_t kMaxCellsInMotion = 800;

struct BeginInMotion {
  double s_mm = 0.0;        // on the first block
  bool has_before = false;  // the window begins with the block before the first, which is over
  StartState state{};       // in motion
  // A way to rest from there, by the way from the motion on: the search begins with it.
  struct Feed {
    double way_mm = 0.0;
    double v_mm_s = 0.0;
  };
  std::vector<Feed> to_rest{};
};

// Lets the waiting cells begin where the motion is, with the way to rest as what is planned so far.
// So many of them are to be planned first; 0: there are too few.
std::size_t prepare_to_begin(const BeginInMotion& from, const PlanLimits& limits,
                             WaitingCells& waiting, Window<Block>& blocks);

}  // namespace kerf::lookahead
