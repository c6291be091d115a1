// Which line of the program a place on a block belongs to.
#pragma once

#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// s_mm: where on the block's curve the line's part begins. Binary search; a place at a mark is of
// the mark's line.
LineMark mark_at(const Block& block, double s_mm);

}  // namespace kerf::lookahead
