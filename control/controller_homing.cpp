// Homing: one move of the search after the other.
#include <string>

#include "control/controller_impl.hpp"

namespace kerf {

using State = ControllerState;

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

}  // namespace kerf
