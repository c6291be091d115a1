// The tick side of a controller, and what any thread may do or see.
#include "control/controller_impl.hpp"
#include "interp/outputs.hpp"

namespace kerf {

using State = ControllerState;

ControllerState Controller::Impl::tick(Setpoint& setpoint) noexcept {
  const interp::TickCalls::Call call(calls_);
  if (closed_) {
    home_search_.see(*closed_, last_);
  }
  if (call.has_news()) {
    ticked_ = running_.load(std::memory_order_acquire);
  }
  Kernel* const kernel = ticked_;
  Ticked ticked{.before = state_.load()};
  if (kernel != nullptr) {
    ticked.status = tick(*kernel, ticked.before.state());
  } else {
    rest(call.has_news());
  }
  last_.tick = tick_.fetch_add(1, std::memory_order_relaxed);
  is_held_by_feed_ = ticked.status == TickStatus::held && ticked.before.state() == State::running;
  publish();
  if (kernel != nullptr) {
    follow(ticked, *kernel);
  }
  tell_wait();
  setpoint = last_;
  return state_.state();
}

TickStatus Controller::Impl::tick(Kernel& kernel, State state) noexcept {
  if (state == State::emergency_stop || state == State::fault) {
    kernel.emergency_stop();
  }
  const Setpoint before = last_;
  const std::uint64_t block_before = detail_.block;
  const bool by_hand = by_hand_.load(std::memory_order_relaxed);
  has_new_place_ = false;
  kernel.set_program_inputs(inputs_);
  const TickStatus status = kernel.tick(last_);
  detail_ = kernel.detail();
  if (by_hand) {  // the program's block, line and way stay as they are
    detail_.block = block_before;
    last_.line = before.line;
    last_.s_mm = before.s_mm;
  } else {
    run_ticks_.fetch_add(1, std::memory_order_relaxed);
    line_.store(last_.line, std::memory_order_relaxed);
  }
  return status;
}

void Controller::Impl::follow(Ticked tick, const Kernel& kernel) noexcept {
  wait_cause_.store(detail_.wait_cause, std::memory_order_relaxed);
  waits_for_answer_.store(tick.status == TickStatus::waiting, std::memory_order_relaxed);
  waits_for_machine_.store(detail_.waits_for_machine, std::memory_order_relaxed);
  const auto change_if = [&](State from, State to) {
    if (tick.before.state() == from) {
      change(tick.before, to);
    }
  };
  switch (tick.status) {
    case TickStatus::running:
      if (detail_.waits_for_machine ||  // or the wait is answered, and nothing follows
          (is_text_late_.load(std::memory_order_relaxed) &&
           detail_.wait_cause != WaitCause::none)) {
        change_if(State::running, State::waiting);
      } else {
        change_if(State::waiting, State::running);
      }
      break;
    case TickStatus::starved:
    case TickStatus::waiting:
      change_if(State::running, State::waiting);
      break;
    case TickStatus::held:
      change_if(State::holding, State::held);
      if (is_text_late_.load(std::memory_order_relaxed) &&
          wants_text_.load(std::memory_order_relaxed)) {  // it is over, and nothing is planned
        change_if(State::running, State::waiting);
      } else {  // by the feed
        change_if(State::waiting, State::running);
      }
      break;
    case TickStatus::finished:
    case TickStatus::failed:
    case TickStatus::emergency_stop:
      end(kernel.has_fault() ? State::fault : State::idle);
      break;
  }
}

// The planning side ends what was moved by hand.
void Controller::Impl::end(State next) noexcept {
  ticked_ = nullptr;
  running_.store(nullptr, std::memory_order_release);
  auto seen = state_.load();
  while (seen.state() != State::emergency_stop && seen.state() != State::fault &&
         !(is_by_hand(seen.state()) && next != State::fault) && !change(seen, next)) {
  }
}

void Controller::Impl::rest(bool has_news) noexcept {
  has_new_place_ = has_news && state_.state() == State::homing && home_search_.take_place(last_);
  last_.v_mm_s = last_.a_mm_s2 = last_.j_mm_s3 = 0.0;
  last_.velocity_mm_s = last_.acceleration_mm_s2 = {};
  last_.limit = Constraint::rest;
  if (has_news) {
    interp::override_spindle(spindle_ratio_.exchange(1.0, std::memory_order_relaxed),
                             last_.outputs);
  }
  if (!drives_on()) {
    last_.outputs.spindle_rad_s = 0.0;
    last_.outputs.surface = {};
    last_.outputs.mist = last_.outputs.flood = false;
  }
}

void Controller::Impl::publish() noexcept {
  snapshot_.write({.programs = programs_.load(),
                   .run_s = static_cast<double>(run_ticks_.load()) * settings_.limits.period_s,
                   .is_held_by_feed = is_held_by_feed_,
                   .door_open = door_open_.load(std::memory_order_relaxed),
                   .block = detail_.block,
                   .setpoint = last_});
}

// A wait that becomes another one is an event, too.
void Controller::Impl::tell_wait() noexcept {
  const State state = state_.state();
  const WaitsFor waits = waits_for(state);
  if (state == State::waiting && told_wait_ != WaitsFor::nothing && waits != told_wait_) {
    note_state(state, last_.line);
  }
  told_wait_ = waits;
}

void Controller::Impl::note_state(State state, std::uint32_t line) noexcept {
  const WaitsFor waits = waits_for(state);
  events_.note({.state = state,
                .waits_for = waits,
                .wait_cause = waits == WaitsFor::answer ? wait_cause_.load() : WaitCause::none,
                .line = line});
}

void Controller::Impl::leave_for(State next) noexcept {
  auto seen = state_.load();
  while (!change(seen, next)) {
  }
  if (next == State::fault) {
    home_search_.forget_homes();
  }
}

bool Controller::Impl::drives_on() const noexcept {
  const control::StateWord::Seen seen = state_.load();
  const State state = seen.state();
  return state != State::off && state != State::fault &&
         (state != State::emergency_stop || (running_.load() != nullptr && !seen.has_failed()));
}

WaitsFor Controller::Impl::waits_for(State state) const noexcept {
  if (waits_for_machine_.load() && (state == State::waiting || state == State::holding)) {
    return WaitsFor::machine;
  }
  return state != State::waiting    ? WaitsFor::nothing
         : waits_for_answer_.load() ? WaitsFor::answer
         : wants_text_.load()       ? WaitsFor::text
                                    : WaitsFor::planning;
}

ControllerStatus Controller::Impl::status() const noexcept {
  ControllerStatus status = snapshot_.read();
  const Published by = published_.read();
  status.overrides = by.overrides;
  status.feed_inputs = by.feed_inputs;
  // After a resume it may rest for a moment, too.
  status.is_held_by_feed =
      status.is_held_by_feed && (by.overrides.feed < Overrides::kLeastFeed || by.feed_inputs.stop ||
                                 by.feed_inputs.adaptive < Overrides::kLeastFeed);
  status.single_block = by.single_block;
  status.optional_stop = by.optional_stop;
  status.block_delete = by.block_delete;
  status.codes = by.codes;
  status.left_s = by.left_s;
  status.unhomed = home_search_.unhomed();
  status.state = state_.state();
  status.next_event = events_.next_number();
  status.waits_for = waits_for(status.state);
  status.wait_cause = status.waits_for == WaitsFor::answer ? wait_cause_.load() : WaitCause::none;
  return status;
}

}  // namespace kerf
