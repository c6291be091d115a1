// Which words a block may have, and what is said of the others.
#pragma once

#include "parser/modal/running_block.hpp"

namespace kerf::parser {

// Refuses words that nothing in the block uses. Gives the code that takes the axis words from the
// motion; Group::count: none does. With Fanuc a D that nothing uses is kept for later.
Expected<Group> check_words(const RunningBlock& at, ModalState& state, bool compensating);

}  // namespace kerf::parser
