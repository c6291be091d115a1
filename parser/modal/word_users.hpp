// Which words the codes beside the motion take.
#pragma once

#include "parser/block/block.hpp"
#include "parser/modal/codes.hpp"

namespace kerf::parser {

// Letters that the block's codes take, without those of its motion and without axis letters.
Letters letters_of_codes(const BlockCodes& codes);

// The number of the block's codes that take `letter`; its motion does not count.
int users_of(const BlockCodes& codes, char letter);

// The code that takes the block's axis words instead of a motion: G10, G28, G30, G52, G92, G43.1,
// G43.2 without H, G51, G68. Group::count where there is none. Precondition: the block has axis
// words.
Group taker_of_axes(const BlockWords& block, const BlockCodes& codes);
// G43.1 and G43.2 without H do, whoever else takes them.
bool offset_takes_axes(const BlockWords& block, const BlockCodes& codes);

}  // namespace kerf::parser
