// The parameters #5061 to #5599 and #<_x> and its like that the machine's state gives.
#pragma once

#include <optional>
#include <string_view>

#include "parser/expressions/predefined_values.hpp"
#include "parser/modal/program_memory.hpp"

namespace kerf::parser {

// As LinuxCNC documents them, A, B, C in degrees. In the machine's unit, mm, whatever the
// program's: #5161 to #5169 (G28), #5181 to #5189 (G30), #5211 to #5219 (G52, G92), #5221 to #5390
// (work offsets, ten numbers each after #5220, the number of the one in force, R in degrees),
// #5401 to #5413 (tool in the spindle). In the program's units: #5061 to #5069 (G38), #5420 to
// #5428 (position). #5399 is what M66 read.
//
// Fanuc's numbers, all in the program's units: #5001.. and #5041.. (position), #5021.. (on the
// machine), #5061.. (G31), #5081.. (tool offset), #5221.. to #5321.., #7001.. and #14001.. (work
// offsets), #2001.., #11001.. (lengths of tools), #13001.. (radii), #4001.. and #4109, #4119, #4120
// (modes). Writing #3000 and #3006 raises ModalState::signal.
//
// Writing an offset in force takes effect when it is chosen anew, writing #5211 to #5219 at the
// next G92.3; Fanuc's take effect at once. #5400 to #5413 and #5420 to #5428 cannot be written.
class MachineValues final : public PredefinedValues {
 public:
  // `memory` must outlive this object.
  explicit MachineValues(ProgramMemory& memory) : memory_(&memory) {}

  [[nodiscard]] std::optional<double> number(int number) const override;
  [[nodiscard]] std::optional<double> name(std::string_view name) const override;
  bool take(int number, double value) override;

 private:
  [[nodiscard]] std::optional<double> fanuc_number(int number) const;
  bool fanuc_take(int number, double value);
  [[nodiscard]] std::optional<double> tool_value(int number) const;
  [[nodiscard]] std::optional<double> work_value(int number) const;
  [[nodiscard]] std::optional<double> special(std::string_view name) const;
  [[nodiscard]] std::optional<double> place(std::string_view name) const;

  ProgramMemory* memory_;
};

}  // namespace kerf::parser
