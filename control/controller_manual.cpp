// What moves by hand: jogs, the way back to a hold, homing.
#include <string>
#include <string_view>
#include <utility>

#include "control/controller_impl.hpp"
#include "interp/outputs.hpp"

namespace kerf {

using State = ControllerState;

namespace {

constexpr std::string_view kNotGivenAgain = "it was not given again";

}  // namespace

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

tl::expected<control::ManualMove, std::string_view> Controller::Impl::move_of(
    const Jog& jog) const {
  return control::move_of(jog, here(), home_search_.unhomed(), settings_);
}

tl::expected<void, Refusal> Controller::Impl::jog(const Jog& jog) {
  follow_ticks();
  for (auto seen = state_.load();;) {
    const auto refused = [&](std::string_view why) {
      return tl::unexpected(Refusal{.state = seen.state(), .command = Command::jog, .reason = why});
    };
    if (const Answer answer = answer_to(seen.state(), Command::jog); !answer.is_accepted()) {
      return refused(answer.refusal);
    }
    if (const std::string_view why = door_refusal(Command::jog); !why.empty()) {
      return refused(why);
    }
    if (seen.state() == State::jogging && renews(jog)) {
      manual_.renewed_tick = seen_.ticks;
      return {};
    }
    const auto move = move_of(jog);
    if (!move) {
      return refused(move.error());
    }
    if (seen.state() == State::jogging) {
      queue_jog(jog);
      return {};
    }
    const State before = seen.state();
    if (change(seen, State::jogging)) {
      is_suspended_ = before == State::held;
      begin_jog(jog, *move);
      return {};
    }
  }
}

bool Controller::Impl::renews(const Jog& jog) const noexcept {
  return jog == manual_.jog && !jog.is_step && !manual_.ends && !manual_.next;
}

void Controller::Impl::begin_jog(const Jog& jog, const control::ManualMove& move) {
  manual_.jog = jog;
  manual_.stops = false;  // it was the one before
  manual_.renewed_tick = seen_.ticks;
  if (is_suspended_) {
    manual_.way_back.push_back(control::place_of(here()));
  }
  run(move);
}

// After the present one, which ends early unless it is a step.
void Controller::Impl::queue_jog(const Jog& jog) {
  std::optional<Jog>& next = manual_.next;
  manual_.next_tick = seen_.ticks;
  if (next && next->is_step && jog.is_step) {
    for (std::size_t axis = 0; axis < jog.mm.size(); ++axis) {
      next->mm[axis] += jog.mm[axis];
    }
    for (std::size_t axis = 0; axis < kAuxiliaryAxes; ++axis) {
      next->extra_rad_mm[axis] += jog.extra_rad_mm[axis];
    }
    next->step_mm_s = jog.step_mm_s;
    if (next == Jog{.is_step = true, .step_mm_s = jog.step_mm_s}) {
      next.reset();  // there and back
    }
  } else {
    next = jog;
  }
  if (!manual_.jog.is_step) {
    end_move();
  }
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

void Controller::Impl::follow_jog() {
  const auto is_silent_since = [this](std::int64_t tick) {
    return static_cast<double>(seen_.ticks - tick) * settings_.limits.period_s >
           settings_.manual.jog_timeout_s;
  };
  if (seen_.running != nullptr) {
    if (!manual_.jog.is_step && !manual_.ends && is_silent_since(manual_.renewed_tick)) {
      stop_manual();
    }
    manual_.kernel->plan();
    return;
  }
  if (const auto next = std::exchange(manual_.next, std::nullopt)) {
    const bool is_stale = !next->is_step && is_silent_since(manual_.next_tick);
    const auto move = seen_.door_open ? tl::unexpected(kDoorIsOpen)
                      : is_stale      ? tl::unexpected(kNotGivenAgain)
                                      : move_of(*next);
    if (move) {
      begin_jog(*next, *move);
      manual_.renewed_tick = manual_.next_tick;
      return;
    }
    say("the jog that was to follow is left out: " + std::string(move.error()));
  }
  leave_manual_for(is_suspended_ ? State::held : State::idle);
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

void Controller::Impl::follow_homing() {
  if (seen_.running != nullptr) {
    if (const auto complaint = home_search_.complaint(seen_.ticks)) {
      fail_to_home(*complaint);
    } else if (home_search_.has_found()) {
      end_move();
    }
    manual_.kernel->plan();
    return;
  }
  if (stops_at_rest()) {
    if (!home_search_.is_placing(seen_.at)) {
      leave_manual_for(State::idle);
    }
    return;
  }
  control::HomeSearch::Move move;
  const control::HomeSearch::Next next = home_search_.next(seen_.at, move);
  if (state_.state() != State::homing) {
    if (state_.state() == State::fault) {  // it came while an axis got its place
      home_search_.forget_homes();
    }
    return;
  }
  switch (next) {
    case control::HomeSearch::Next::moves: {
      control::AxisTargets to = control::place_of(here());
      to.mm[move.axis] = move.to_mm;
      run({.to = to, .mm_s = move.mm_s});
      break;
    }
    case control::HomeSearch::Next::waits:
      break;
    case control::HomeSearch::Next::gives_place:
      tell_ticks();
      break;
    case control::HomeSearch::Next::done:
      leave_manual_for(State::idle);
      break;
    case control::HomeSearch::Next::failed:
      fail_to_home(home_search_.failure());
      break;
  }
}

void Controller::Impl::fail_to_home(const std::string& why) {
  say(why);
  leave_for(State::fault);
}

void Controller::Impl::say(const std::string& text) {
  events_.note({.kind = ControllerEvent::Kind::message,
                .state = state_.state(),
                .message = messages_.add({.text = text})});
}

}  // namespace kerf
