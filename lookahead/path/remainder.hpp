// A stretch of a block, and what is left of one after a place on it.
#pragma once

#include <memory>
#include <optional>

#include "lookahead/path/block.hpp"

namespace kerf::lookahead {

// The same path with the same limits as a block of its own, with the marks on it; `continues` is
// false. Nothing: it is too short to be a curve. Precondition: 0 <= begin < end <= length_mm.
std::optional<Block> stretch_of(const Block& block, const curves::Stretch& stretch);

// The block from s_mm on, to be planned like any other: its curve is that part of the block's, and
// its limits are the same. What is emitted of it is on the whole block's curve (on_whole_mm).
// Nothing: it is too short to be a curve. Precondition: the block is whole, 0 <= s_mm < length_mm.
std::optional<Block> remainder_of(const std::shared_ptr<const Block>& whole, double s_mm);

// The block that it is the remainder of, or the block itself.
Block whole_of(Block&& block);

}  // namespace kerf::lookahead
