#include "interp/plan_in_force.hpp"

#include <algorithm>

namespace kerf::interp {

void PlanInForce::take_over(std::int64_t tick) noexcept {
  for (std::size_t i = 0; i < MotionQueue::kTakeovers; ++i) {
    const Takeover* next = queue_->next_takeover();
    if (next == nullptr || (next->from == plan_ && next->tick > tick)) {
      break;
    }
    const std::uint32_t plan = next->plan;
    const bool takes = may_take(*next, tick);
    queue_->pop_takeover();
    if (takes) {
      plan_ = plan;
      stop_next_ = stop_.count;
    }
    give_answer(plan);
  }
  take_stop(tick);
  drop_stale_phases();
}

bool PlanInForce::may_take(const Takeover& next, std::int64_t tick) const noexcept {
  return next.from == plan_ && next.tick == tick && queue_->is_committed(next.phases_end);
}

void PlanInForce::take_stop(std::int64_t tick) noexcept {
  const StopAhead* stop = queue_->has_stop() ? queue_->take_stop(plan_, tick) : nullptr;
  if (stop == nullptr) {
    return;
  }
  stop_.count = stop->count;
  std::copy_n(stop->phases.begin(), stop->count, stop_.phases.begin());
  plan_ = stop->plan;
  stop_next_ = 0;
  give_answer(plan_);
}

// A plan that is still to take over is next in its queue before its phases are committed.
void PlanInForce::drop_stale_phases() noexcept {
  for (std::size_t i = 0; i < MotionQueue::kPhases; ++i) {
    const Phase* next = queue_->next_phase();
    if (next == nullptr || next->plan == plan_) {
      return;
    }
    const Takeover* takeover = queue_->next_takeover();
    if (takeover != nullptr && takeover->plan == next->plan) {
      return;
    }
    queue_->pop_phase();
  }
}

}  // namespace kerf::interp
