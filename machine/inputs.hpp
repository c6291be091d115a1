// What a machine says beside the places of its axes.
#pragma once

#include <array>
#include <cstdint>

#include <kerf/setpoint.hpp>

namespace kerf::machine {

// One bit an axis: bit 0 is x, then y, z, a, b, c, u, v, w.
using AxisBits = std::uint16_t;

struct MachineInputs {
  bool probe = false;  // it touches
  bool door_open = false;
  bool emergency_loop_open = false;  // somebody has pushed the button, or a wire is broken
  bool tool_changed = true;          // the tool of the last setpoint is in the spindle
  bool spindle_at_speed = true;      // it turns as the last setpoint says; at rest, too
  AxisBits home = 0;                 // switches that are closed
  AxisBits lower_limit = 0;
  AxisBits upper_limit = 0;
  std::uint64_t digital = 0;  // bit n: input n
  std::array<double, Outputs::kAnalog> analog{};

  friend bool operator==(const MachineInputs&, const MachineInputs&) = default;
};

}  // namespace kerf::machine
