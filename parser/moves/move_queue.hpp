// The moves of one block, in order, until they are fetched. Allocates only while it grows to the
// longest block so far: a canned cycle with many repeats makes thousands of moves.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "parser/moves/move.hpp"

namespace kerf::parser {

class MoveQueue {
 public:
  MoveQueue() : slots_(kUsual) {}

  [[nodiscard]] bool empty() const { return begin_ == end_; }
  // A place for one more move; what an earlier move left there is to be overwritten.
  Move& push() {
    if (end_ == slots_.size()) {
      slots_.resize(2 * slots_.size());
    }
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
  // Tool, spindle, coolant, dwell, motion, stop, and some.
  static constexpr std::size_t kUsual = 8;

  std::vector<Move> slots_;
  std::size_t begin_ = 0;
  std::size_t end_ = 0;
};

}  // namespace kerf::parser
