// A three-axis table with servo drives, simulated.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <kerf/machine.hpp>

#include "machine/axis_model.hpp"
#include "machine/machine.hpp"
#include "machine/path_history.hpp"
#include "machine/setpoint_gate.hpp"
#include "machine/simulated_world.hpp"

namespace kerf::machine {

// Every number is valid (gains, lead, counts and drive limits positive, friction and integral
// not negative, feed_forward in 0..1, min < max, period in 1e-5..0.1 s) and finite where the struct
// does not say otherwise.
[[nodiscard]] bool is_valid(const TableSettings& settings) noexcept;

// Deterministic: the same calls give the same states to the last bit. One write() is one period;
// its work is bounded (see AxisModel and PathHistory) and allocates nothing.
//
// State: actual_mm is what the encoders read, whole counts; after an encoder failed, its last good
// reading. The commanded position is the last setpoint that was not refused. contour_error_mm is
// the distance to the path through the setpoints (PathHistory), so lag along it does not count.
//
// The axes A, B, C, U, V, W have no drives here: they are where the setpoint says, and only their
// travel is checked.
class SimulatedTable final : public Machine {
 public:
  // A table whose settings are not valid (is_valid) stays in the fault not_enabled. tools: for the
  // probe.
  explicit SimulatedTable(const TableSettings& settings, const SimulationSettings& world = {},
                          std::vector<ToolOffset> tools = {});

  void enable(const AxisPlaces& places) noexcept override;
  void disable() noexcept override;
  void set_unhomed(AxisBits axes) noexcept override { gate_.set_unhomed(axes); }
  void write(const Setpoint& setpoint) noexcept override;
  [[nodiscard]] MachineState read() const noexcept override { return state_; }

  // Break something of an axis (0..2; others are ignored) until enable().
  void fail_encoder(std::size_t axis, EncoderFailure failure, double jump_mm = 0.0) noexcept;
  void weaken(std::size_t axis) noexcept;
  void jam(std::size_t axis) noexcept;
  void trip(std::size_t axis) noexcept;  // its drive switches itself off

 private:
  [[nodiscard]] bool accepts(const Setpoint& setpoint) noexcept;
  void stop_axes() noexcept;
  void observe() noexcept;
  [[nodiscard]] double longest_step_mm(std::size_t axis) const noexcept;
  // Whatever the encoders read.
  [[nodiscard]] Position true_place_mm() const noexcept;
  void fault(DriveFault kind, std::int8_t axis) noexcept;

  TableSettings settings_;
  SetpointGate gate_;
  std::array<AxisModel, 3> axes_;
  PathHistory path_;
  SimulatedWorld world_;
  Position commanded_mm_{};
  MachineState state_{.fault = DriveFault::not_enabled};
  bool valid_;
};

}  // namespace kerf::machine
