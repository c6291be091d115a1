// Hands planned motion over to the tick side, as far as it may be frozen yet.
#pragma once

#include <cstddef>
#include <cstdint>

#include "interp/motion_queue.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

class Delivery {
 public:
  explicit Delivery(interp::MotionQueue& queue) : queue_(&queue) {}

  // What the planner has planned and is to be delivered.
  [[nodiscard]] lookahead::Outbox& outbox() { return outbox_; }

  // Moves what begins up to tick `horizon` into the queue, pieces first: a phase follows only once
  // the piece that it begins on, the lines up to there and what is switched as it begins are there.
  // True: all phases went; pieces and lines that only later ones need may still wait in the outbox.
  bool deliver(std::int64_t horizon);

  // The last phase that was delivered begins there.
  [[nodiscard]] std::int64_t frozen_until_tick() const noexcept { return frozen_until_tick_; }

 private:
  [[nodiscard]] bool may_follow(const interp::Phase& phase) const;
  void forget_sent();

  interp::MotionQueue* queue_;
  lookahead::Outbox outbox_;
  std::size_t pieces_sent_ = 0;
  std::size_t line_changes_sent_ = 0;
  std::size_t phases_sent_ = 0;
  std::size_t output_changes_sent_ = 0;
  std::int64_t frozen_until_tick_ = 0;
};

}  // namespace kerf
