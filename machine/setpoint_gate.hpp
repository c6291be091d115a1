// What no machine takes: a number that is not finite, and a place outside the travel. Of the axes
// that can have a home switch, X, Y and Z, those that are not homed have no travel.
#pragma once

#include <cstdint>
#include <optional>

#include <kerf/machine.hpp>

#include "machine/envelope.hpp"
#include "machine/machine.hpp"

namespace kerf::machine {

// Called from the tick.
class SetpointGate {
 public:
  // Places beyond this are outside the travel of any machine: 10 km.
  static constexpr double kFarthestMm = 1e7;

  struct Refusal {
    DriveFault why = DriveFault::not_finite;
    std::int8_t axis = -1;  // as MachineState::fault_axis
  };

  explicit SetpointGate(const TableSettings& settings) noexcept;

  // They have no travel.
  void set_unhomed(AxisBits axes) noexcept;
  // Nothing: they may pass.
  [[nodiscard]] std::optional<Refusal> refusal(const Setpoint& setpoint) const noexcept;
  // Of places where the axes are enabled: those that are not finite alone.
  [[nodiscard]] static std::optional<Refusal> refusal(const AxisPlaces& places) noexcept;

 private:
  Envelope travel_;
  Envelope envelope_;  // the travel of axes that are homed
  AuxiliaryEnvelope extra_;
};

}  // namespace kerf::machine
