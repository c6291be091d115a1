// Fanuc's numbers without a decimal point.
#pragma once

#include "parser/block/block.hpp"
#include "parser/modal/modal_state.hpp"

namespace kerf::parser {

// Multiplies the block's coordinates and distances that have no decimal point by the control's
// least increment: with 0.001 mm X1000 is X1. In inches the increment is a tenth of that many
// inches, as on the control (IS-B: 0.001 mm, 0.0001 inch); times and angles count in thousandths.
// Words of an expression, feeds, counts and numbers of things stay as they are.
void count_in_least_increments(const ModalState& state, double least_increment_mm, Block& block);

}  // namespace kerf::parser
