// Jogs: given again while a key is pressed, or steps, one after the other.
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "control/controller_impl.hpp"

namespace kerf {

using State = ControllerState;

namespace {

constexpr std::string_view kNotGivenAgain = "it was not given again";

}  // namespace

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

}  // namespace kerf
