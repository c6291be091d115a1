// What is assumed of a machine where no ticks are: in a check, an estimate, an explanation.
#pragma once

#include <kerf/machine.hpp>

#include "parser/modal/machine_source.hpp"

namespace kerf {

// The surface and the inputs of the simulation, in closed form: the tip of the tool is where the
// program has it, and inputs stay as they are set. With KernelOptions::assumes_contact the surface
// is at the end of each way.
class SimulatedAnswers final : public parser::AssumedMachine {
 public:
  SimulatedAnswers(const MachineSettings& settings, bool assumes_contact)
      : world_(settings.simulation),
        tools_(settings.program.tools),
        assumes_contact_(assumes_contact) {}

  [[nodiscard]] bool has_surface() const override {
    return assumes_contact_ || world_.surface.has_value();
  }
  [[nodiscard]] bool touches(const parser::ProbedWay& way) const override;
  [[nodiscard]] std::optional<parser::Point> change_of_contact(
      const parser::ProbedWay& way) const override;
  [[nodiscard]] bool digital(std::size_t input) const override {
    return ((world_.digital >> input) & 1U) != 0;
  }
  [[nodiscard]] double analog(std::size_t input) const override { return world_.analog[input]; }
  [[nodiscard]] double spindle_time_s(double from_per_min, double to_per_min) const override;

 private:
  [[nodiscard]] parser::Point tool_offset_mm(std::int32_t tool) const;

  SimulationSettings world_;
  ToolTable tools_;
  bool assumes_contact_;
};

}  // namespace kerf
