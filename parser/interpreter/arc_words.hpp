// From the words of G2 and G3 to centre and turns.
#pragma once

#include "parser/modal/running_block.hpp"
#include "parser/moves/arc_geometry.hpp"

namespace kerf::parser {

// The arc that the block describes, from state.position_mm to `end_mm`, as RS274/NGC reads it
// [NISTIR 6556, 3.5.3]. In the radius form a radius up to 0.01 mm shorter than half the chord is
// taken as a half circle. In the centre form the radii at the start and at the end may differ by
// 0.0283 mm, or by 0.1 % up to 2.83 mm, which are LinuxCNC's limits.
// Precondition: the block has no word that an arc cannot use.
Expected<ArcMove> build_arc(const BlockWords& block, const ModalState& state, const Point& end_mm);

}  // namespace kerf::parser
