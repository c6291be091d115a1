#include "kernel/kernel_impl.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "kernel/program_state.hpp"

namespace kerf {

Outputs Kernel::Impl::outputs_at_begin(const KernelOptions& options) {
  Outputs outputs = options.start_outputs;
  if (const auto* left = options.begins_with.content()) {
    const parser::AllowedOverrides& allowed = left->of_reader.modal.overrides;
    outputs.follows_speed_override = allowed.speed;
    outputs.follows_adaptive_feed = allowed.adaptive_feed;
    outputs.heeds_feed_stop = allowed.feed_hold;
  }
  return outputs;
}

bool Kernel::Impl::plan() {
  if (tells_) {
    follow_tool();
  }
  const std::int64_t begin = now();
  // Read first: the plan that it came on is the one that is followed then.
  const interp::InquiryAnswer* answer = asks_ ? interpolator_.watch().answer() : nullptr;
  if (!follow_stop_ahead()) {
    return false;
  }
  if (answer != nullptr) {
    follow_machine(*answer);
  }
  forget_before(begin);
  follow_commands();
  if (keeps_stop_ && !runs_low()) {
    return false;
  }
  const bool wants_text = fill_queue();
  if (!tells_ || !announces_now()) {
    hand_over();
  }
  return wants_text;
}

// The tick side may be on another plan by now, from a tick before: the machine may have braked, a
// plan that was to take over may be refused, and a stop ahead taken.
void Kernel::Impl::forget_before(std::int64_t tick) {
  if (!asks_ && !takeover_ && !queue_.stop_taken()) {
    pipeline_.forget_before(tick);
  }
}

void Kernel::Impl::follow_tool() {
  if (has_come_to_end()) {
    if (!notes_.is_at_end()) {
      notes_.reach_end(pipeline_.path().reader().state_left({}).modal);
    }
  } else if (has_errors() && has_run_all()) {
    notes_.reach(std::numeric_limits<std::uint64_t>::max());
  } else {
    notes_.reach(interpolator_.reached_block());
    if (notes_.has_more_to_say()) {
      const bool has_run_what_was_read =
          rests_for_text_ && interpolator_.plan_tick() >= pipeline_.emitted_until_tick();
      notes_.announce(has_run_what_was_read
                          ? std::numeric_limits<std::uint64_t>::max()
                          : pipeline_.rest_block_at(interpolator_.plan_tick() + announced_ticks_));
    }
  }
  notes_.follow({.path_mm = interpolator_.reached_path_mm(),
                 .moved_s = static_cast<double>(interpolator_.plan_tick()) * period_s_,
                 .overrides = {.feed = feed_share(),
                               .rapid = overrides_.rapid,
                               .spindle = overrides_.spindle},
                 .feed_is_0 = overrides_.feed == 0.0});
}

// Where the tool rests and nothing was planned yet, a message would come after the wait that is
// planned now. So it is told first, and the next call hands over.
bool Kernel::Impl::announces_now() {
  if (!keeps_stop_ || !notes_.has_more_to_say() || committed_until_tick_ > now()) {
    return false;
  }
  return notes_.announce(pipeline_.rest_block_at(now() + announced_ticks_));
}

// Also in what it began with: a program that is refused leaves that.
bool Kernel::Impl::set_tool(const Tool& tool) {
  if (!is_possible(tool)) {
    return false;
  }
  pipeline_.set_tool(tool);
  if (begins_with_.content() != nullptr) {
    ProgramState::Content content = *begins_with_.content();
    content.of_reader.machine.tools.put(tool);
    begins_with_ = ProgramState(std::move(content));
  }
  return true;
}

// A program that was stopped, or ended before an error, is after what was read.
ProgramState Kernel::Impl::state_left() const {
  const parser::ProgramReader& reader = pipeline_.path().reader();
  if (has_come_to_end()) {
    return ProgramState({.of_reader = reader.state_left({})});
  }
  if (notes_.state()) {
    return ProgramState({.of_reader = reader.state_left(notes_.state())});
  }
  return begins_with_;
}

bool Kernel::Impl::has_run_all() const noexcept {
  return pipeline_.is_finished() && interpolator_.plan_tick() >= pipeline_.emitted_until_tick();
}

bool Kernel::Impl::has_come_to_end() const noexcept {
  return has_run_all() && !has_errors() && !stops_ && !pipeline_.is_held() &&
         !interpolator_.is_emergency();
}

// Of the programmed feedrate, where the tool is.
double Kernel::Impl::feed_share() const noexcept {
  const double adaptive = interpolator_.heeded().adaptive_feed ? adaptive_ : 1.0;
  return is_at_feed_0() ? 0.0 : feed_ * adaptive;
}

bool Kernel::Impl::fill_queue() {
  int taken = 0;
  while (!broken_ && delivery_.deliver(now() + horizon_ticks_)) {
    const bool was_finished = pipeline_.is_finished();
    switch (pipeline_.step(delivery_.outbox())) {
      case Pipeline::Step::planned:
        fail_with_check();
        hand_on();
        break;
      case Pipeline::Step::took:
        rests_for_text_ = false;
        if (pipeline_.is_finished() && !was_finished) {
          fail_with_check();
          end_ = pipeline_.path().programmed_end();
          wrong_ = pipeline_.path().has_errors();
        }
        if (const auto inquiry = pipeline_.take_inquiry()) {
          static_cast<void>(now());
          interpolator_.watch().ask(*inquiry);
          asks_ = true;
        }
        if (++taken >= kManyTaken && !pipeline_.wants_block() && is_nearly_half_ahead()) {
          return false;  // the search over what was taken is for the next call
        }
        break;
      case Pipeline::Step::wants_text:
        return true;
      case Pipeline::Step::ended:
      case Pipeline::Step::held:
        return false;
    }
  }
  return false;
}

bool Kernel::Impl::is_nearly_half_ahead() const {
  return delivery_.frozen_until_tick() - now() > horizon_ticks_ * 7 / 16;
}

TickStatus Kernel::Impl::tick(Setpoint& setpoint) noexcept {
  const interp::TickCalls::Call call(calls_);
  if (call.has_news()) {
    interpolator_.take_spindle_override();
  }
  const TickStatus status = interpolator_.next(setpoint);
  if (status == TickStatus::starved) {
    judge_.starve();
  }
  if (interpolator_.is_emergency()) {
    return status;  // no promise holds any more
  }
  judge_.add(setpoint, interpolator_.chord_error_mm());
  if (status == TickStatus::finished && end_ && judges_end_) {
    judge_.judge_end(setpoint, *end_);
  }
  const TickStatus heeded = status == TickStatus::waiting ? status_at_wait() : status;
  // Of a broken plan nothing follows a rest but a wait that is not answered yet.
  const bool rests = status == TickStatus::starved || status == TickStatus::held ||
                     (status == TickStatus::waiting && heeded == TickStatus::running);
  const bool ends = status == TickStatus::finished || (rests && broken_);
  return !ends ? heeded : has_fault() || wrong_ ? TickStatus::failed : TickStatus::finished;
}

TickStatus Kernel::Impl::status_at_wait() const noexcept {
  const std::uint32_t wait = interpolator_.wait();
  if (wait == answered_wait_.load(std::memory_order_relaxed)) {
    return TickStatus::running;  // the plan that follows the answer may not be there yet
  }
  return wait == held_wait_.load(std::memory_order_relaxed) ? TickStatus::held
                                                            : TickStatus::waiting;
}

// At a hold or a wait that is over by the plan, which has nothing after it.
bool Kernel::Impl::rests_behind_wait(TickStatus status) const noexcept {
  const std::uint32_t wait = interpolator_.wait();
  return status == TickStatus::held || (status == TickStatus::running && wait != 0 &&
                                        wait == answered_wait_.load(std::memory_order_relaxed));
}

void Kernel::Impl::reach_tick() {
  while (interpolator_.pass_what_is_over()) {
    plan();
    if (queue_.next_phase() == nullptr) {
      return;  // no more is planned
    }
  }
}

TickStatus Kernel::Impl::next(Setpoint& setpoint) {
  keeps_stop_ = false;
  const bool is_asked = wants_hold_ || wants_resume_ || wants_change_ || takeover_ ||
                        stopped_feed_.any() || (asks_ && interpolator_.watch().answer() != nullptr);
  const bool wants_text = (is_asked || runs_low()) && plan();
  if (wants_text && runs_low()) {
    plan_to_rest();
  }
  reach_tick();
  const TickStatus status = tick(setpoint);
  // There is one thread: what is not planned now never is.
  if (wants_text && rests_behind_wait(status)) {
    return TickStatus::starved;
  }
  if (status == TickStatus::starved && pipeline_.is_finished()) {
    pipeline_.fail_without_plan(setpoint.line);
    fail_with_check();
  }
  return status;
}

void Kernel::Impl::plan_to_rest() {
  if (!pipeline_.is_finished()) {
    pipeline_.flush();
    if (plan()) {
      pipeline_.plan_to_rest();
      plan();
      rests_for_text_ = true;
    }
  }
}

}  // namespace kerf
