// Finds the feedrates: the part of the planner in which profiles differ.
#pragma once

#include "lookahead/emit/emitter.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// Whether more blocks follow.
enum class Supply {
  wanted,   // more blocks may come before the schedule has to emit
  full,     // no more blocks fit into the window
  to_rest,  // no block follows until the motion has come to rest
};

// Plans the blocks of a window that its owner holds, and removes them from the front once they have
// been emitted.
class Schedule {
 public:
  Schedule() = default;
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;
  virtual ~Schedule() = default;

  // The last block of the window is new.
  virtual void push(const Window<Block>& blocks) = 0;
  // True: nothing is left to emit.
  [[nodiscard]] virtual bool empty() const = 0;
  // False: it holds as much as it can plan at once.
  [[nodiscard]] virtual bool has_room() const = 0;
  // Appends motion. False: it needs more blocks first. Precondition: not empty.
  virtual bool emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) = 0;
};

}  // namespace kerf::lookahead
