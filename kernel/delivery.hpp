// Hands planned motion to the tick side, up to the horizon.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "interp/motion_queue.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

class Delivery {
 public:
  explicit Delivery(interp::MotionQueue& queue) : queue_(&queue) {}

  // Planned motion that waits to be delivered.
  [[nodiscard]] lookahead::Outbox& outbox() { return outbox_; }

  // Moves phases up to tick `horizon` into the queue; pieces, line changes and output changes as
  // far as there is room. A phase goes only after the piece it begins on, the line changes up to
  // there and the output changes that it counts. True: all phases were moved; what only later
  // phases need may remain.
  bool deliver(std::int64_t horizon);

  // A new plan, whole to its rest, takes over where it begins, on a tick; phases that wait and
  // begin later than that are dropped. The path in the outbox stays.
  void take_over(lookahead::Outbox&& plan);

  // The tick at which the last delivered phase begins.
  [[nodiscard]] std::int64_t frozen_until_tick() const noexcept { return frozen_until_tick_; }

 private:
  [[nodiscard]] bool may_follow(const interp::Phase& phase) const;
  void send_path();
  void send_changes_before(const interp::Phase& phase);
  void forget_sent();

  interp::MotionQueue* queue_;
  lookahead::Outbox outbox_;
  std::size_t pieces_sent_ = 0;
  std::size_t line_changes_sent_ = 0;
  std::size_t phases_sent_ = 0;
  std::size_t output_changes_sent_ = 0;
  std::uint64_t output_changes_gone_ = 0;       // that are in the outbox no more
  std::uint64_t output_changes_counted_ = 0;    // by the phases that were sent
  std::optional<interp::Takeover> takeover_{};  // goes behind the last phase that waits
  std::int64_t frozen_until_tick_ = 0;
};

}  // namespace kerf
