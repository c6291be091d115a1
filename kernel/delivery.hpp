// Hands planned motion to the tick side, up to the horizon.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>

#include "interp/motion_queue.hpp"
#include "lookahead/planner.hpp"

namespace kerf {

class Delivery {
 public:
  // look: called right before each change that the tick side sees.
  Delivery(interp::MotionQueue& queue, std::function<void()> look)
      : queue_(&queue), look_(std::move(look)) {}

  // Planned motion that waits to be delivered.
  [[nodiscard]] lookahead::Outbox& outbox() { return outbox_; }

  // Moves phases up to tick `horizon` into the queue; pieces, line changes and output changes as
  // far as there is room. A phase goes only after the piece it begins on, the line changes up to
  // there and the output changes that it counts. True: all phases were moved; what only later
  // phases need may remain. Room for a plan that takes over stays free.
  bool deliver(std::int64_t horizon);

  // A new plan takes over from that one where it begins; phases that wait and begin later than that
  // are dropped. The path in the outbox stays. It is whole to its rest, or a way to rest goes on
  // from it. Commits.
  enum class HandedOver : std::uint8_t {
    no,       // there is no room for it and its way to rest; nothing was dropped
    whole,    // nothing was dropped
    for_good  // what was emitted before is no longer whole: if this plan is refused, another must
              // come
  };
  HandedOver take_over(lookahead::Outbox&& plan, std::uint32_t from,
                       const lookahead::Planner::PlannedStopAhead* ahead = nullptr);

  // The tick side gets what was moved. False: it has taken the stop ahead, and goes no farther.
  bool commit() { return commit(interp::MotionQueue::Ahead::none); }
  // The same, with a way to rest for the tick by which nothing else has come.
  enum class Committed : std::uint8_t {
    yes,
    stop_taken,  // the tick side has taken the stop ahead, and goes no farther
    no_room      // for the path of that way to rest, yet: nothing is committed
  };
  Committed commit(const lookahead::Planner::PlannedStopAhead& ahead, std::uint32_t from);
  // The tick side follows its stop ahead; what waits is superseded.
  void follow_stop();

  // Of the path up to the end of that way to rest, how much has no room yet.
  [[nodiscard]] double missing_mm(const lookahead::Planner::PlannedStopAhead& ahead) const;
  // All phases were moved, and the path to the end of the last one is in the queue.
  [[nodiscard]] bool is_whole() const { return outbox_.phases.empty() && may_end_with(last_); }
  // The tick at which the last delivered phase begins.
  [[nodiscard]] std::int64_t frozen_until_tick() const noexcept { return frozen_until_tick_; }

 private:
  struct Until {
    std::int64_t horizon = 0;
    std::size_t phases_free = 0;  // in the queue
  };
  bool deliver(const Until& until);
  bool commit(interp::MotionQueue::Ahead ahead) {
    look_();
    return queue_->commit(ahead);
  }
  [[nodiscard]] bool may_follow(const interp::Phase& phase) const;
  // The path up to its end and the output changes that it counts are in the queue.
  [[nodiscard]] bool may_end_with(const interp::Phase& phase) const;
  // The path up to there is in the queue.
  [[nodiscard]] bool reaches(std::uint64_t on_curve, double at_mm) const;
  void append_path(const lookahead::Outbox& plan);
  // False: the path up to its rest, which is in the outbox or sent, does not fit.
  bool write_stop(const lookahead::Planner::PlannedStopAhead& ahead, std::uint32_t from);
  void send_path();
  void send_changes_before(const interp::Phase& phase);
  void forget_sent();

  interp::MotionQueue* queue_;
  std::function<void()> look_;
  lookahead::Outbox outbox_;
  std::size_t pieces_sent_ = 0;
  std::size_t line_changes_sent_ = 0;
  std::size_t phases_sent_ = 0;
  std::size_t output_changes_sent_ = 0;
  std::uint64_t output_changes_gone_ = 0;     // that are in the outbox no more
  std::uint64_t output_changes_counted_ = 0;  // by the phases that were sent
  std::int64_t frozen_until_tick_ = 0;
  interp::Phase last_{};  // that was delivered
};

}  // namespace kerf
