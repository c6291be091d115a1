#include "interp/outputs.hpp"

namespace kerf::interp {

namespace {

void stop_spindle(Outputs& outputs) noexcept {
  outputs.spindle_rad_s = 0.0;
  outputs.spindle_held = false;
}

void set_digital(const Switch& change, Outputs& outputs) noexcept {
  const auto output = static_cast<std::size_t>(change.index);
  if (output < Outputs::kDigital) {
    const std::uint64_t bit = std::uint64_t{1} << output;
    outputs.digital = change.value != 0.0 ? outputs.digital | bit : outputs.digital & ~bit;
  }
}

}  // namespace

void apply(const Switch& change, Outputs& outputs) noexcept {
  switch (change.kind) {
    case SwitchKind::spindle:
      stop_spindle(outputs);
      outputs.spindle_rad_s = change.value;
      break;
    case SwitchKind::hold_spindle:
      stop_spindle(outputs);
      outputs.spindle_angle_rad = change.value;
      outputs.spindle_held = true;
      break;
    case SwitchKind::tool_change:
      stop_spindle(outputs);
      outputs.tool = static_cast<std::int32_t>(change.value);
      break;
    case SwitchKind::tool_number:
      outputs.tool = static_cast<std::int32_t>(change.value);
      break;
    case SwitchKind::mist_on:
      outputs.mist = true;
      break;
    case SwitchKind::flood_on:
      outputs.flood = true;
      break;
    case SwitchKind::coolant_off:
      outputs.mist = outputs.flood = false;
      break;
    case SwitchKind::digital:
      set_digital(change, outputs);
      break;
    case SwitchKind::analog:
      if (static_cast<std::size_t>(change.index) < Outputs::kAnalog) {
        outputs.analog[static_cast<std::size_t>(change.index)] = change.value;
      }
      break;
    case SwitchKind::all_off:
      stop_spindle(outputs);
      outputs.mist = outputs.flood = false;
      break;
  }
}

}  // namespace kerf::interp
