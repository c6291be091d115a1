// Motions to come to rest from.
#pragma once

#include <vector>

#include "lookahead/optimum/braking.hpp"

namespace kerf::lookahead::test {

// At the begin of the first. The blocks stay where they are.
inline BrakingFrom from_begin_of(const std::vector<Block>& blocks, double v_mm_s) {
  BrakingFrom from{.blocks = {}, .state = {.v_mm_s = v_mm_s}};
  for (const Block& block : blocks) {
    from.blocks.push_back(&block);
  }
  return from;
}

}  // namespace kerf::lookahead::test
