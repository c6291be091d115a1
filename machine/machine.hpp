// The receiver of setpoints: a drive, or its simulation.
#pragma once

#include <cstdint>

#include "curves/auxiliary_axis_motion.hpp"
#include "interp/outputs.hpp"
#include "interp/setpoint.hpp"

namespace kerf::machine {

using curves::Position;
using interp::Setpoint;

enum class DriveFault : std::uint8_t {
  none,
  not_enabled,      // no enable() yet
  soft_limit,       // a setpoint outside the travel
  following_error,  // an axis fell too far behind
  not_finite,       // a setpoint or an encoder that is not a number
};

struct MachineState {
  Position actual_mm{};
  Position following_error_mm{};  // commanded - actual
  double contour_error_mm = 0.0;  // distance of the actual position from the commanded path
  interp::Outputs outputs{};      // of the last setpoint that was not refused; after a fault
                                  // spindle and coolant are off
  DriveFault fault = DriveFault::none;
  std::int8_t fault_axis = -1;  // x, y, z, a, b, c, u, v, w; -1 where no axis is to blame
};

// Called from the tick: no member allocates, locks, logs or throws.
class Machine {
 public:
  virtual ~Machine() = default;
  Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  // Switches the drives on at rest at position_mm and clears a fault. A position that is not finite
  // is the fault not_finite at once.
  virtual void enable(const Position& position_mm) noexcept = 0;
  // Takes the setpoint of the next tick; one call is one period of time. A setpoint that is not
  // finite or outside the travel is refused with its fault. After a fault setpoints are ignored
  // and all axes come to rest together, until enable().
  virtual void write(const Setpoint& setpoint) noexcept = 0;
  [[nodiscard]] virtual MachineState read() const noexcept = 0;
};

}  // namespace kerf::machine
