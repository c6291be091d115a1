// The moves of one block, in order, until they are fetched. Never allocates.
#pragma once

#include <array>
#include <cassert>
#include <cstddef>
#include <utility>

#include "parser/move.hpp"

namespace kerf::parser {

class MoveQueue {
 public:
  // A block makes at most six: tool, spindle, coolant, dwell, motion, stop.
  static constexpr std::size_t kCapacity = 8;

  [[nodiscard]] bool empty() const { return begin_ == end_; }
  // A place for one more move; what an earlier move left there is to be overwritten.
  Move& push() {
    assert(end_ < kCapacity);
    return slots_[end_++];
  }
  // Precondition: not empty.
  void pop(Move& move) {
    move = std::move(slots_[begin_++]);
    if (begin_ == end_) {
      begin_ = end_ = 0;
    }
  }

 private:
  std::array<Move, kCapacity> slots_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace kerf::parser
