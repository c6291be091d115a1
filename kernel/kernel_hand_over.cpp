// What goes from the planning side of a kernel to its ticks, and what it learns of them.
#include <algorithm>
#include <utility>

#include "kernel/kernel_impl.hpp"

namespace kerf {

// The tick side may wait for it, and goes on while more is planned.
void Kernel::Impl::hand_on() {
  if (keeps_stop_) {
    return;
  }
  const std::int64_t tick = now();
  delivery_.deliver(tick + horizon_ticks_);
  hand_over();
  forget_before(tick);
}

void Kernel::Impl::hand_over() {
  const std::int64_t tick_now = now();
  if ((pipeline_.is_held() && !pipeline_.is_held_by_feed()) || pipeline_.awaits_answer()) {
    queue_.commit();  // the stop ahead stays: the plan may be refused
    return;
  }
  if (!keeps_stop_ || (delivery_.is_whole() && pipeline_.ends_at_rest())) {
    commit();
    return;
  }
  const std::int64_t part = horizon_ticks_ / kPartsOfHorizon;
  std::int64_t until = delivery_.frozen_until_tick();
  if (until - committed_until_tick_ < part) {
    // A ramp is one phase, and may be longer than the horizon: the way to rest leads from within.
    until = std::max(until, std::min(pipeline_.emitted_until_tick(), tick_now + horizon_ticks_));
  }
  if (until - committed_until_tick_ < part && committed_until_tick_ - tick_now > part) {
    return;
  }
  commit_up_to(until);
}

// Near the end of what is in the queue, or before it where there is no way to rest from there.
// Without one the stop ahead stays as it is, and is tried again with what is planned by then.
void Kernel::Impl::commit_up_to(std::int64_t until) {
  const std::int64_t emitted = pipeline_.emitted_until_tick();
  const std::int64_t earliest = std::max(committed_until_tick_, now()) + 1;
  if (earliest > emitted || now() < next_commit_tick_) {
    return;
  }
  std::int64_t tick = until - margin_ticks_;
  bool has_room = true;
  for (std::int64_t step = margin_ticks_; tick > earliest;) {
    const StopCommit found = commit_with_stop(tick);
    if (found.done) {
      return;
    }
    has_room &= found.too_late_ticks == 0;
    tick -= std::max(step *= 2, found.too_late_ticks);
  }
  if (commit_with_stop(earliest).done) {
    return;
  }
  if (!has_room) {
    next_commit_tick_ = now() + horizon_ticks_ / kPartsOfHorizon;  // until the tool has moved on
    return;
  }
  // Within a ramp that takes all of the acceleration there may be none, and after it there is.
  tick = until + 1;
  for (std::int64_t step = margin_ticks_; tick < emitted && !commit_with_stop(tick).done;) {
    tick += step *= 2;
  }
}

Kernel::Impl::StopCommit Kernel::Impl::commit_with_stop(std::int64_t tick) {
  auto ahead = pipeline_.stop_ahead(tick);
  if (!ahead) {
    return {};
  }
  const std::int64_t until = ahead->stop.from.when.tick;
  delivery_.deliver(until);
  if (pipeline_.ends_at_rest() && ahead->stop.from.at_rest() &&
      until == pipeline_.emitted_until_tick()) {
    // The plan ends with that rest: what waits there or ends the program is the plan's own.
    if (!delivery_.is_whole()) {
      return {};
    }
    commit();
    return {.done = true};
  }
  switch (delivery_.commit(*ahead, pipeline_.plan())) {
    case Delivery::Committed::no_room:
      return {.too_late_ticks = too_late_ticks(*ahead)};
    case Delivery::Committed::yes:
      committed_until_tick_ = until;
      stop_ahead_ = std::move(ahead);
      break;
    case Delivery::Committed::stop_taken:
      break;
  }
  return {.done = true};
}

std::int64_t Kernel::Impl::too_late_ticks(const lookahead::Planner::PlannedStopAhead& ahead) const {
  const double missing_mm = delivery_.missing_mm(ahead);
  const double tick_mm = ahead.stop.from.v_mm_s * period_s_;
  const auto all = static_cast<double>(horizon_ticks_);
  return 1 + static_cast<std::int64_t>(missing_mm < all * tick_mm ? missing_mm / tick_mm : all);
}

void Kernel::Impl::commit() {
  if (delivery_.commit()) {
    committed_until_tick_ = delivery_.frozen_until_tick();
  }
}

bool Kernel::Impl::follow_stop_ahead() {
  if (!queue_.stop_taken()) {
    return true;
  }
  const std::uint32_t in_force = interpolator_.answer().in_force;
  if (takeover_ && takeover_->stop && takeover_->stop->plan == in_force) {
    auto stop = std::move(takeover_->stop);
    settle(true);
    stop_ahead_ = std::move(stop);
  } else if (in_force != stop_ahead_->plan) {
    return false;
  } else if (takeover_) {
    settle(false);  // it was to replace the plan before
  }
  pipeline_.follow_stop_ahead(*stop_ahead_);
  fail_with_check();
  delivery_.follow_stop();
  committed_until_tick_ = now();
  return true;
}

void Kernel::Impl::follow_machine(const interp::InquiryAnswer& answer) {
  if (takeover_) {
    settle(interpolator_.answer().in_force == takeover_->plan);
  }
  if (answer.has_braked) {
    notes_.end_path_at(interpolator_.reached_path_mm());
    delivery_.follow_stop();
    committed_until_tick_ = now();
    wants_hold_ = holds_ || stops_;
  }
  pipeline_.follow(answer);
  asks_ = false;
}

}  // namespace kerf
