// How feedrates are found: the part of the planner that profiles differ in.
#pragma once

#include "lookahead/emit/emitter.hpp"
#include "lookahead/path/block.hpp"
#include "lookahead/path/limits.hpp"
#include "lookahead/path/window.hpp"

namespace kerf::lookahead {

// How much is known of what follows.
enum class Supply {
  wanted,   // more blocks may come before the schedule must go on
  full,     // no more fit
  to_rest,  // none follow until the motion has come to rest
};

// Plans the blocks of a window that its owner holds, and takes them from its front once they are
// emitted. Whatever it has emitted can be followed by a stop.
class Schedule {
 public:
  Schedule() = default;
  Schedule(const Schedule&) = delete;
  Schedule& operator=(const Schedule&) = delete;
  virtual ~Schedule() = default;

  // The window's last block is new.
  virtual void push(const Window<Block>& blocks) = 0;
  // Nothing is left to emit.
  [[nodiscard]] virtual bool empty() const = 0;
  // False: it holds as much as it can plan at once.
  [[nodiscard]] virtual bool has_room() const = 0;
  // Appends some motion. False: it wants more blocks first. Precondition: not empty.
  virtual bool emit(Window<Block>& blocks, Supply supply, Emitter& emitter, Outbox& outbox) = 0;
  // What is left is cut down to the shortest way to a rest.
  virtual void stop(const Window<Block>& blocks, const Emitter& emitter) = 0;
};

}  // namespace kerf::lookahead
