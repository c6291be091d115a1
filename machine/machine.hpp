// The receiver of setpoints: a drive, or its simulation. docs/machine-interface.md says what a
// machine must do, and what the kernel promises it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "curves/auxiliary_axis_motion.hpp"
#include "interp/outputs.hpp"
#include "interp/setpoint.hpp"
#include "machine/inputs.hpp"

namespace kerf::machine {

using curves::AuxiliaryPosition;
using curves::Position;
using interp::Setpoint;

inline constexpr std::size_t kAllAxes = 3 + curves::kAuxiliaryAxes;

// Where all axes are.
struct AxisPlaces {
  Position mm{};
  AuxiliaryPosition extra_rad_mm{};

  friend bool operator==(const AxisPlaces&, const AxisPlaces&) = default;
};

enum class DriveFault : std::uint8_t {
  none,
  not_enabled,       // no enable() yet, or disable() since
  soft_limit,        // a setpoint outside the travel
  following_error,   // an axis fell too far behind
  not_finite,        // a setpoint or an encoder that is not a number
  another_run,       // a record that is replayed is told something else than what it holds
  no_answer,         // a machine in another process does not answer in time
  bad_answer,        // it answers what is no frame, or none that was asked for
  connection_lost,   // it is gone
  encoder_jump,      // an encoder reads what no drive can have done in a period
  drive_tripped,     // a drive has switched itself off
  limit_switch,      // an axis has run into its limit switch
  spindle_too_slow,  // the spindle does not come to its speed in time
};
inline constexpr DriveFault kLastDriveFault = DriveFault::spindle_too_slow;

enum class AxisState : std::uint8_t {
  off,
  on,        // it follows the setpoints
  stopping,  // for a fault, its own or another axis'; setpoints do not count
};

struct MachineState {
  Position actual_mm{};
  AuxiliaryPosition extra_rad_mm{};  // the same of A, B, C, U, V, W
  Position following_error_mm{};     // commanded - actual
  double contour_error_mm = 0.0;     // distance of the actual position from the commanded path
  interp::Outputs outputs{};         // of the last setpoint that was not refused; after a fault
                                     // spindle and coolant are off
  MachineInputs inputs{};
  bool has_latched = false;  // the drive knows where X, Y and Z were as the probe's input changed
  Position latched_mm{};     // within the last tick
  std::array<AxisState, kAllAxes> axes{};
  DriveFault fault = DriveFault::none;  // while axes are on: bring them to rest with setpoints
  std::int8_t fault_axis = -1;          // x, y, z, a, b, c, u, v, w; -1 where no axis is to blame
};

// Called from the tick: no member allocates, locks, logs or throws, and none waits.
class Machine {
 public:
  virtual ~Machine() = default;
  Machine() = default;
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  // Switches the drives on at rest at these places and clears a fault. A place that is not finite
  // is the fault not_finite at once.
  virtual void enable(const AxisPlaces& places) noexcept = 0;
  // Switches them off; axes that move come to rest together, as after a fault. It is the fault
  // not_enabled until enable(), but where there is one already.
  virtual void disable() noexcept = 0;
  // Nobody knows where these axes are: from the next setpoint on they have no travel.
  virtual void set_unhomed(AxisBits /*axes*/) noexcept {}
  // Takes the setpoint of the next tick; one call is one period of time. A setpoint that is not
  // finite or outside the travel is refused with its fault. After a fault setpoints are ignored
  // and all axes come to rest together, until enable(). A machine that can still follow may leave
  // its axes on in a fault: then setpoints count, and bring it to rest on the path.
  virtual void write(const Setpoint& setpoint) noexcept = 0;
  // As of the last of these calls.
  [[nodiscard]] virtual MachineState read() const noexcept = 0;
  // That is as of this tick's setpoint or a later one. False: so a machine that answers later will
  // say at a later call.
  [[nodiscard]] virtual bool has_answered(std::int64_t /*tick*/) const noexcept { return true; }
};

}  // namespace kerf::machine
