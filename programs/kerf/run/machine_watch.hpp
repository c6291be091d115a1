// What the inputs of a machine say against the motion.
#pragma once

#include <bit>
#include <cstdint>

#include "machine/machine.hpp"

namespace kerf::program {

struct MachineFault {
  machine::DriveFault kind = machine::DriveFault::none;
  std::int8_t axis = -1;
  std::uint32_t line = 0;
  std::int64_t tick = 0;
};

// For the tick.
class MachineWatch {
 public:
  MachineWatch(double spindle_timeout_s, double period_s) noexcept
      : spindle_ticks_(spindle_timeout_s / period_s) {}

  // The fault of the machine, or else of its inputs, as of the setpoint.
  [[nodiscard]] MachineFault look(const machine::Setpoint& setpoint,
                                  const machine::MachineState& state) noexcept {
    MachineFault fault{.line = setpoint.line, .tick = setpoint.tick};
    const auto limits = static_cast<unsigned>(state.inputs.lower_limit | state.inputs.upper_limit);
    const bool turns = setpoint.outputs.spindle_rad_s != 0.0;
    slow_ticks_ = turns && !state.inputs.spindle_at_speed ? slow_ticks_ + 1.0 : 0.0;
    if (state.fault != machine::DriveFault::none) {
      fault.kind = state.fault;
      fault.axis = state.fault_axis;
    } else if (limits != 0) {
      fault.kind = machine::DriveFault::limit_switch;
      fault.axis = static_cast<std::int8_t>(std::countr_zero(limits));
    } else if (slow_ticks_ > spindle_ticks_) {
      fault.kind = machine::DriveFault::spindle_too_slow;
    }
    return fault;
  }

 private:
  double spindle_ticks_;
  double slow_ticks_ = 0.0;  // in a row
};

// Whether an axis may be elsewhere than it says, so that it is to be homed.
[[nodiscard]] constexpr bool may_lose_place(machine::DriveFault fault) noexcept {
  using machine::DriveFault;
  return fault == DriveFault::following_error || fault == DriveFault::not_finite ||
         fault == DriveFault::encoder_jump || fault == DriveFault::limit_switch ||
         fault == DriveFault::connection_lost;
}

}  // namespace kerf::program
