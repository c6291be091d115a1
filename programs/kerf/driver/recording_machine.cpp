#include "programs/kerf/driver/recording_machine.hpp"

namespace kerf::program {

using machine::DriveFault;

void RecordingMachine::enable(const machine::AxisPlaces& places) noexcept {
  inner_->enable(places);
  keep(told_places(places));
}

void RecordingMachine::disable() noexcept {
  inner_->disable();
  keep({.call = MachineCall::disable});
}

void RecordingMachine::write(const Setpoint& setpoint) noexcept {
  inner_->write(setpoint);
  keep({.setpoint = setpoint});
}

void RecordingMachine::keep(const ToldFrame& told) noexcept {
  record_->push(
      {.told = to_bytes(told),
       .answer = to_bytes(AnswerFrame{.tick = told.setpoint.tick, .state = inner_->read()})});
}

void ReplayingMachine::enable(const machine::AxisPlaces& places) noexcept {
  follow(told_places(places));
}

void ReplayingMachine::disable() noexcept {
  follow({.call = MachineCall::disable});
}

void ReplayingMachine::write(const Setpoint& setpoint) noexcept {
  follow({.setpoint = setpoint});
}

bool ReplayingMachine::has_answered(std::int64_t /*tick*/) const noexcept {
  const auto calls = record_.calls();
  const auto told = next_ < calls.size() ? told_from(calls[next_].told) : std::nullopt;
  return !told || told->call != MachineCall::write;
}

void ReplayingMachine::follow(const ToldFrame& told) noexcept {
  if (state_.fault == DriveFault::another_run) {
    return;
  }
  const auto calls = record_.calls();
  const bool same = next_ < calls.size() && calls[next_].told == to_bytes(told);
  const auto answer = same ? answer_from(calls[next_].answer) : std::nullopt;
  ++next_;
  if (answer) {
    state_ = answer->state;
    return;
  }
  state_.fault = DriveFault::another_run;
  state_.fault_axis = -1;
  state_.axes.fill(machine::AxisState::off);
  interp::apply({.kind = interp::OutputChangeKind::all_off}, state_.outputs);
}

}  // namespace kerf::program
