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
      plan_ = told_plan_ = plan;
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
  plan_ = told_plan_ = stop->plan;
  stop_next_ = 0;
  give_answer(plan_);
}

std::uint32_t PlanInForce::brake(const Phase& phase, std::span<const profiles::CellLaw> laws,
                                 const BrakeFrom& from) noexcept {
  plan_ = (plan_ + 2U) | 1U;
  Phase part = phase;
  part.begin = from.begin;
  part.s_begin_mm = part.s_end_mm = from.s_mm;
  part.plan = plan_;
  part.law = profiles::Transition::rest(0.0);
  part.active_constraint = {};
  part.ends_at_rest = part.holds = part.ends_program = false;
  part.wait = 0;
  stop_.count = stop_next_ = 0;
  for (const profiles::CellLaw& law : laws) {
    part.law = law;
    part.active_constraint = active_constraint(Constraint::path_jerk);
    part.s_begin_mm = part.s_end_mm;
    part.s_end_mm += law.length_mm();
    stop_.phases[stop_.count++] = part;
    const double offset_s = part.begin.offset_s + law.duration_s();
    const auto whole = static_cast<std::int64_t>(offset_s / from.period_s);
    part.begin = {.tick = part.begin.tick + whole,
                  .offset_s = offset_s - static_cast<double>(whole) * from.period_s};
  }
  if (laws.empty()) {
    stop_.phases[stop_.count++] = part;
  }
  stop_.phases[stop_.count - 1].ends_at_rest = true;
  return plan_;
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
