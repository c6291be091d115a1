// What the simulated table's sensors feel: the probe, switches, inputs and the spindle.
#pragma once

#include <cstdint>
#include <vector>

#include <kerf/simulation.hpp>

#include "machine/machine.hpp"
#include "machine/touch_surface.hpp"

namespace kerf::machine {

// Of the tools that have one, ascending by number.
struct ToolOffset {
  std::int32_t tool = 0;
  Position offset_mm{};
};

// Numbers are valid and finite where SimulationSettings does not say otherwise.
[[nodiscard]] bool is_valid(const SimulationSettings& settings) noexcept;

class SimulatedWorld {
 public:
  // Settings that are not valid (is_valid) count as none.
  SimulatedWorld(SimulationSettings settings, std::vector<ToolOffset> tools, double period_s);

  // The table is switched on there; the spindle keeps its speed.
  void restart(const Position& place_mm, MachineState& state) noexcept;
  // One tick later: the inputs, from where the axes truly are, with state.outputs in force.
  // Allocates nothing.
  void feel(const Position& place_mm, MachineState& state) noexcept;

 private:
  [[nodiscard]] Position tool_offset_mm(std::int32_t tool) const noexcept;
  void feel_probe(const Position& place_mm, MachineState& state) noexcept;
  void feel_switches(const Position& place_mm, MachineInputs& inputs) const noexcept;
  void turn_spindle(double commanded_rad_s) noexcept;

  SimulationSettings settings_;
  std::vector<ToolOffset> tools_;
  double spindle_step_rad_s_;  // of a tick; 0: it follows at once
  double spindle_rad_s_ = 0.0;
  Position tip_mm_{};
  std::int32_t tool_ = 0;
  bool touches_ = false;
};

}  // namespace kerf::machine
