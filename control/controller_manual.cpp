// What jogs, the way back to a hold and homing share: a kernel for each move, and the way back
// itself.
#include <string>
#include <utility>

#include "control/controller_impl.hpp"
#include "interp/outputs.hpp"

namespace kerf {

using State = ControllerState;

void Controller::Impl::look_at_ticks() {
  const auto read = [this] {
    seen_ = {.running = running_.load(),
             .state = state_.state(),
             .door_open = door_open_.load(),
             .ticks = tick_.load(),
             .spindle_ratio = spindle_ratio_.load(),
             .at = here()};
    home_search_.look();
  };
  if (options_.plan_clock) {
    calls_.follow(options_.plan_clock, read);
  } else {
    read();
  }
}

void Controller::Impl::follow_ticks() {
  look_at_ticks();
  follow_manual();
  look_at_ticks();  // planning takes its time
  follow_spindle();
}

// What runs by the program follows the override itself. At rest, by hand or in no program, the
// spindle turns on from what ran last.
void Controller::Impl::follow_spindle() {
  const double share = operator_.overrides.spindle;
  if (seen_.running != nullptr || seen_.spindle_ratio != 1.0 || share == spindle_share_) {
    return;
  }
  share_before_ = std::exchange(spindle_share_, share);
  spindle_ratio_.store(share / share_before_, std::memory_order_relaxed);
  tell_ticks();
  look_at_ticks();
}

Setpoint Controller::Impl::rest_as_programmed() const {
  Setpoint at = here();
  at.outputs = seen_.at.outputs;
  if (at.outputs.follows_speed_override) {
    at.outputs.spindle_rad_s /= seen_.spindle_ratio == 1.0 ? spindle_share_ : share_before_;
  }
  return at;
}

void Controller::Impl::tell_ticks() {
  const auto at_once = [](std::int64_t /*ticks*/) { return true; };
  options_.plan_clock ? calls_.tell(options_.plan_clock) : calls_.tell(at_once);
}

void Controller::Impl::run(const control::ManualMove& move) {
  Setpoint at = rest_as_programmed();
  spindle_share_ = operator_.overrides.spindle;
  interp::override_spindle(spindle_share_, at.outputs);
  manual_.kernel = control::kernel_of(move, at, settings_, options_);
  manual_.ends = false;
  by_hand_ = true;
  run(*manual_.kernel);
}

void Controller::Impl::run(Kernel& kernel) {
  spindle_ratio_ = 1.0;  // it begins with that
  running_.store(&kernel);
  seen_.running = &kernel;
  tell_ticks();
}

void Controller::Impl::end_move() {
  if (seen_.running != nullptr && !std::exchange(manual_.ends, true)) {
    manual_.kernel->stop();
  }
}

void Controller::Impl::stop_manual() {
  manual_.next.reset();
  manual_.stops = true;
  end_move();
}

void Controller::Impl::follow_manual() {
  switch (seen_.state) {
    case State::off:
    case State::emergency_stop:
    case State::fault:
      if (seen_.running == nullptr) {
        is_suspended_ = false;
        manual_ = {};
        home_search_.drop_place();
      }
      break;
    case State::jogging:
      follow_jog();
      break;
    case State::returning:
      follow_return();
      break;
    case State::homing:
      follow_homing();
      break;
    default:
      break;
  }
}

// The new state, unless there was an emergency stop or a fault.
void Controller::Impl::leave_manual_for(State next) {
  manual_.stops = false;
  manual_.kernel.reset();
  auto seen = state_.load();
  if (is_by_hand(seen.state())) {
    change(seen, next);
  }
}

bool Controller::Impl::begin_return() {
  auto seen = state_.load();
  return seen.state() == State::held && change(seen, State::returning);
}

// While the door is open no next move begins.
bool Controller::Impl::stops_at_rest() {
  if (seen_.door_open && !std::exchange(manual_.stops, true)) {
    say(std::string(kDoorIsOpen));
  }
  return manual_.stops;
}

// One move after the other, each to where a jog began.
void Controller::Impl::follow_return() {
  if (manual_.kernel && seen_.running != nullptr) {
    manual_.kernel->plan();
    return;
  }
  if (stops_at_rest()) {
    leave_manual_for(State::held);
    return;
  }
  if (manual_.kernel) {
    manual_.way_back.pop_back();
  }
  if (!manual_.way_back.empty()) {
    run({.to = manual_.way_back.back(), .mm_s = settings_.manual.jog_mm_s});
    return;
  }
  is_suspended_ = false;
  kernel_->resume();
  leave_manual_for(State::running);
  run_program();
}

void Controller::Impl::end_suspended() {
  is_suspended_ = false;
  manual_ = {};
  auto seen = state_.load();
  if (seen.state() == State::stopping) {
    change(seen, State::idle);
  }
}

void Controller::Impl::say(const std::string& text) {
  events_.note({.kind = ControllerEvent::Kind::message,
                .state = state_.state(),
                .message = messages_.add({.text = text})});
}

}  // namespace kerf
