// [axes.a] to [axes.w] of a machine file, and who else may name these axes.
#include "kernel/machine_file_checks.hpp"
#include "kernel/machine_file_reader.hpp"
#include "parser/moves/auxiliary_axes.hpp"

namespace kerf {

// That the table is there names the axis.
void MachineFileReader::read_extra_axis(const Section& section, std::size_t axis) {
  settings_.program.extra_axes |= parser::letter_bit(parser::kAuxiliaryNames[axis]);
  const auto rules = extra_axis_rules(parser::is_rotary(axis));
  read_numbers(section, rules, axis);
  for (const NumberRule& limit : rules.last(3)) {
    if (!section.table->contains(limit.key)) {
      report(section.table->source(),
             section.path_to(limit.key) + ": expected a limit, which this axis must have");
    }
  }
  const toml::node* const upper = section.table->get(rules[1].key);
  if (const auto problem = travel_problem(rules, settings_, axis); problem && upper != nullptr) {
    report(upper->source(), section.path_to(rules[1].key) + ": " + *problem);
  }
}

// The keys of [offsets.*] for axes that the machine does not have.
void MachineFileReader::check_offset_axes(const Section& section,
                                          std::span<const NumberRule> extra_rules) {
  for (std::size_t axis = 0; axis < extra_rules.size(); ++axis) {
    const toml::node* const node = section.table->get(extra_rules[axis].key);
    const char name = parser::kAuxiliaryNames[axis];
    if (node != nullptr && (settings_.program.extra_axes & parser::letter_bit(name)) == 0) {
      report(node->source(), section.path_to(extra_rules[axis].key) +
                                 ": the machine has no such axis: there is no [axes." +
                                 std::string(extra_rules[axis].key.substr(0, 1)) + "]");
    }
  }
}

}  // namespace kerf
