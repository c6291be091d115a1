#include "programs/kerf/driver/faulty_table.hpp"

#include <utility>

namespace kerf::program {

using machine::EncoderFailure;

FaultyTable::FaultyTable(std::unique_ptr<machine::SimulatedTable> table,
                         std::vector<PlannedFault> faults, double period_s)
    : table_(std::move(table)), planned_(std::move(faults)), period_s_(period_s) {}

void FaultyTable::enable(const machine::AxisPlaces& places) noexcept {
  table_->enable(places);
  break_what_is_due();
}

void FaultyTable::write(const machine::Setpoint& setpoint) noexcept {
  break_what_is_due();
  ++ticks_;
  PlannedFault asked;
  while (asked_->pop(asked)) {
    apply(asked);
  }
  table_->write(setpoint);
}

void FaultyTable::break_what_is_due() noexcept {
  const double now_s = static_cast<double>(ticks_) * period_s_;
  while (next_ < planned_.size() && planned_[next_].at_s <= now_s + 0.5 * period_s_) {
    apply(planned_[next_++]);
  }
}

machine::MachineState FaultyTable::read() const noexcept {
  machine::MachineState state = table_->read();
  machine::MachineInputs& inputs = state.inputs;
  inputs.home = static_cast<machine::AxisBits>((inputs.home | stuck_.home_closed) &
                                               ~static_cast<unsigned>(stuck_.home_open));
  inputs.lower_limit = static_cast<machine::AxisBits>(inputs.lower_limit | stuck_.lower_limit);
  inputs.upper_limit = static_cast<machine::AxisBits>(inputs.upper_limit | stuck_.upper_limit);
  inputs.emergency_loop_open = inputs.emergency_loop_open || stuck_.emergency_loop_open;
  inputs.door_open = inputs.door_open || stuck_.door_open;
  inputs.probe = inputs.probe || stuck_.probe;
  if (stuck_.spindle && state.outputs.spindle_rad_s != 0.0) {
    inputs.spindle_at_speed = false;
  }
  return state;
}

void FaultyTable::apply(const PlannedFault& fault) noexcept {
  // -1: none, which the table ignores.
  const std::size_t axis = static_cast<std::uint8_t>(fault.axis);
  switch (fault.what) {
    case TableFault::encoder_frozen:
      table_->fail_encoder(axis, EncoderFailure::frozen);
      return;
    case TableFault::encoder_jump:
      table_->fail_encoder(axis, EncoderFailure::jumped, fault.jump_mm);
      return;
    case TableFault::encoder_not_a_number:
      table_->fail_encoder(axis, EncoderFailure::not_finite);
      return;
    case TableFault::drive_trip:
      table_->trip(axis);
      return;
    case TableFault::drive_weak:
      table_->weaken(axis);
      return;
    case TableFault::axis_jammed:
      table_->jam(axis);
      return;
    default:
      apply_to_inputs(fault);
  }
}

void FaultyTable::apply_to_inputs(const PlannedFault& fault) noexcept {
  const auto bit = static_cast<machine::AxisBits>(
      fault.axis >= 0 ? 1U << static_cast<unsigned>(fault.axis) : 0U);
  const auto set = [bit](machine::AxisBits& bits) {
    bits = static_cast<machine::AxisBits>(bits | bit);
  };
  switch (fault.what) {
    case TableFault::home_switch_closed:
      set(stuck_.home_closed);
      return;
    case TableFault::home_switch_open:
      set(stuck_.home_open);
      return;
    case TableFault::lower_limit_switch:
      set(stuck_.lower_limit);
      return;
    case TableFault::upper_limit_switch:
      set(stuck_.upper_limit);
      return;
    case TableFault::emergency_loop:
      stuck_.emergency_loop_open = true;
      return;
    case TableFault::door_open:
      stuck_.door_open = true;
      return;
    case TableFault::spindle_stuck:
      stuck_.spindle = true;
      return;
    case TableFault::probe_closed:
      stuck_.probe = true;
      return;
    default:
      return;
  }
}

}  // namespace kerf::program
