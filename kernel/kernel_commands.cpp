// What an operator asks of a kernel, and the plans that take over for it.
#include <algorithm>
#include <numeric>
#include <utility>

#include "kernel/kernel_impl.hpp"

namespace kerf {

void Kernel::Impl::hold() {
  holds_ = wants_hold_ = true;
  wants_resume_ = false;
  next_hold_tick_ = 0;
  plan();
}

// A hold at a wait ends, and the wait is answered by the next; at feed 0 it is answered, too.
void Kernel::Impl::resume() {
  holds_ = false;
  wants_hold_ = stops_;
  const bool was_at_wait = holds_at_wait();
  held_wait_.store(0, std::memory_order_relaxed);
  wants_resume_ = !was_at_wait && !stops_;
  plan();
}

void Kernel::Impl::set_single_block(bool on) {
  single_block_ = on;
  pipeline_.keep_blocks_apart(on);
  wants_change_ = true;
  next_try_tick_ = 0;
  plan();
}

void Kernel::Impl::settle(bool accepted) {
  pipeline_.settle(accepted);
  if (takeover_->changes_plan) {
    queue_.settle(accepted);
    if (accepted && takeover_->stop) {
      stop_ahead_ = std::move(takeover_->stop);
    }
  }
  if (!accepted) {
    (takeover_->changes_plan ? wants_change_ : wants_hold_) =
        takeover_->changes_plan || holds_ || stops_;
    // What was emitted before may be cut, and the hold be wanted no more.
    wants_change_ |= pipeline_.awaits_answer();
    committed_until_tick_ = takeover_->committed_before;
  }
  has_stopped_ = has_stopped_ || (accepted && takeover_->ends_program);
  refusals_ = accepted ? 0 : std::min(refusals_ + 1, kMaxRefusals);
  takeover_.reset();
}

bool Kernel::Impl::holds_at_wait() const noexcept {
  const std::uint32_t wait = held_wait_.load(std::memory_order_relaxed);
  return wait != 0 && pipeline_.waits() && pipeline_.wait() == wait;
}

void Kernel::Impl::follow_commands() {
  // Read once: right after the plan the tick side may take its stop ahead.
  const interp::PlanInForce::Answer answer = interpolator_.answer();
  if (takeover_ && answer.plan == takeover_->plan) {
    settle(answer.in_force == takeover_->plan);
  }
  if (!takeover_) {
    follow_resume();
  }
  if (held_wait_.load(std::memory_order_relaxed) != 0 && !takeover_ && !holds_at_wait()) {
    held_wait_.store(0, std::memory_order_relaxed);  // another plan has no wait there
    wants_hold_ = holds_;
  }
  if (!takeover_ && wants_hold_ && now() >= next_hold_tick_) {
    wants_hold_ = !try_hold();
  }
  if (!takeover_ && !holds_ && !stops_ && stopped_feed_.any() && now() >= next_hold_tick_) {
    try_hold_feed();
  }
  if (!takeover_ && wants_change_ && now() >= next_try_tick_) {
    wants_change_ = !try_change_plan();
    next_try_tick_ = wants_change_ ? now() + margin_ticks_ : 0;
  }
}

void Kernel::Impl::follow_resume() {
  if (wants_resume_ && (!wants_hold_ || pipeline_.waits())) {
    go_on();
    wants_resume_ = false;
  }
  if (!holds_ && !stops_ && pipeline_.feed_lets_go()) {
    pipeline_.resume();
  }
}

// A wait that the tool has not come to is not answered, nor one for the machine. In single block a
// question to it may be asked already while the block before it waits.
void Kernel::Impl::go_on() {
  const bool is_there = now() >= pipeline_.emitted_until_tick();
  const bool is_for_machine = asks_ && !pipeline_.waits_for_resume();
  const bool stays = pipeline_.is_held_by_feed() && !pipeline_.feed_lets_go();
  if (stays || (!pipeline_.is_held() && (!is_there || is_for_machine))) {
    return;
  }
  if (pipeline_.waits()) {
    answered_wait_.store(pipeline_.wait(), std::memory_order_relaxed);
  }
  pipeline_.resume();
}

std::int64_t Kernel::Impl::takeover_tick() const {
  const std::int64_t tick = now();
  const std::int64_t last = std::max(pipeline_.emitted_until_tick(), tick);
  return std::min(tick + (margin_ticks_ << refusals_), last);
}

// Half of the time goes to the search for a shorter way.
lookahead::StopOrder Kernel::Impl::stop_order() const {
  const std::int64_t tick = takeover_tick();
  const std::int64_t latest = std::midpoint(now(), tick);
  return {.tick = tick, .is_late = [this, latest] { return now() > latest; }};
}

bool Kernel::Impl::hand_over(lookahead::Outbox&& plan, std::uint32_t from,
                             const lookahead::Planner::PlannedStopAhead* ahead) {
  switch (delivery_.take_over(std::move(plan), from, ahead)) {
    case Delivery::HandedOver::no:
      pipeline_.settle(false);
      takeover_.reset();
      return false;
    case Delivery::HandedOver::for_good:
      pipeline_.cut_plan_before();
      return true;
    case Delivery::HandedOver::whole:
      return true;
  }
  return true;
}

// Where the feed is to stop what begins, the tool may still be on its way there.
bool Kernel::Impl::is_at_hold() const {
  return pipeline_.is_held() &&
         (!pipeline_.is_held_by_feed() || now() >= pipeline_.emitted_until_tick());
}

bool Kernel::Impl::has_room_to_hold() {
  return queue_.phases_free() >= interp::StopAhead::kPhases + delivery_.outbox().phases.size();
}

bool Kernel::Impl::hand_over_hold(lookahead::Outbox&& plan, std::uint32_t from) {
  takeover_ = {.plan = plan.phases.front().plan,
               .ends_program = stops_,
               .committed_before = committed_until_tick_};
  if (!hand_over(std::move(plan), from)) {
    return false;
  }
  committed_until_tick_ = delivery_.frozen_until_tick();
  fail_with_check();
  return true;
}

bool Kernel::Impl::try_hold() {
  if (has_stopped_) {
    return true;
  }
  if (is_at_hold()) {
    if (stops_) {
      judges_end_ = false;
      has_stopped_ = true;
      pipeline_.stop_held();
    }
    return true;
  }
  if (!has_room_to_hold()) {
    return false;
  }
  lookahead::Outbox plan;
  const std::uint32_t from = pipeline_.plan();
  const lookahead::StopOrder order = stop_order();
  if (!(stops_ ? pipeline_.stop(order, plan) : pipeline_.hold(order, plan))) {
    // A trapezoid that brakes all it can is stopped no sooner by any bounded jerk, for hundreds of
    // ticks on end: a search at each of them would leave no time to plan.
    next_hold_tick_ = now() + margin_ticks_ / 2;
    return false;
  }
  if (!plan.phases.empty()) {
    judges_end_ = !stops_;
    return hand_over_hold(std::move(plan), from);
  }
  if (!stops_ && pipeline_.waits()) {
    held_wait_.store(pipeline_.wait(), std::memory_order_relaxed);
  }
  return true;
}

bool Kernel::Impl::try_change_plan() {
  if (stops_) {
    return true;
  }
  if (is_at_feed_0()) {
    return false;  // it holds, until there is another
  }
  if (queue_.phases_free() <
      interp::MotionQueue::kPhasesOfTakeover + delivery_.outbox().phases.size()) {
    return false;
  }
  lookahead::Outbox plan;
  const std::uint32_t from = pipeline_.plan();
  const std::int64_t tick = takeover_tick();
  auto changed = pipeline_.change_plan({.by = {.feed = feed_,
                                               .rapid = overrides_.rapid,
                                               .spindle = overrides_.spindle,
                                               .adaptive = adaptive_},
                                        .single_block = single_block_,
                                        .tick = tick,
                                        .until_tick = tick + (first_part_ticks_ >> shortenings_),
                                        .needs_stop = keeps_stop_},
                                       plan);
  if (!changed) {
    return false;
  }
  if (!plan.phases.empty()) {
    takeover_ = {.plan = plan.phases.front().plan,
                 .changes_plan = true,
                 .committed_before = committed_until_tick_,
                 .stop = std::move(changed->stop)};
    const auto* stop = takeover_->stop ? &*takeover_->stop : nullptr;
    if (!hand_over(std::move(plan), from, stop)) {
      shortenings_ = std::min(shortenings_ + 1, kMaxShortenings);
      return false;
    }
    shortenings_ = 0;
    committed_until_tick_ =
        stop != nullptr ? stop->stop.from.when.tick : delivery_.frozen_until_tick();
    fail_with_check();
  }
  return true;
}

}  // namespace kerf
