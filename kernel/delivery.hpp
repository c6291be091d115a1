// Hands planned motion to the tick side, up to the horizon.
#pragma once

#include <cstddef>
#include <cstdint>

#include "interp/motion_queue.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

class Delivery {
 public:
  explicit Delivery(interp::MotionQueue& queue) : queue_(&queue) {}

  // Planned motion that waits to be delivered.
  [[nodiscard]] lookahead::Outbox& outbox() { return outbox_; }

  // Moves phases and output changes up to tick `horizon` into the queue, pieces and line changes as
  // far as there is room. A phase goes only after the piece it begins on, the line changes up to
  // there and the output changes at its begin. True: all phases and output changes were moved;
  // pieces and line changes that only later phases need may remain.
  bool deliver(std::int64_t horizon);

  // The tick at which the last delivered phase begins.
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
