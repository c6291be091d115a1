// [program] and [inputs] of a machine file.
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "kernel/machine_file_checks.hpp"
#include "kernel/machine_file_reader.hpp"
#include "kernel/machine_file_text.hpp"
#include "parser/dialects/dialect.hpp"

namespace kerf {

namespace {

constexpr std::string_view kWaitsForSpindle = "waits_for_spindle";
constexpr std::array<std::string_view, 7> kProgramKeys{
    "dialect",         "least_increment_mm", "path_mode",     "tool_change_s",
    "spindle_start_s", "safe_z_mm",          kWaitsForSpindle};

}  // namespace

void MachineFileReader::read_program(const Section& section) {
  check_keys(section, kProgramKeys);
  for (const NumberRule& rule : program_rules()) {
    if (const toml::node* const node = section.table->get(rule.key)) {
      rule.field(settings_, 0) = read_number(section, rule, *node).value_or(0.0);
    }
  }
  read_truth(section, kWaitsForSpindle, settings_.program.waits_for_spindle);
  read_dialect(section);
  read_path_mode(section);
}

void MachineFileReader::read_inputs(const Section& section) {
  std::vector<std::string_view> keys;
  for (const InputRule& rule : input_rules()) {
    keys.push_back(rule.number.key);
    const toml::node* const node = section.table->get(rule.number.key);
    const auto number = node != nullptr ? read_number(section, rule.number, *node) : std::nullopt;
    if (const auto problem = number ? input_problem(rule, *number) : std::nullopt) {
      report(node->source(), section.path_to(rule.number.key) + ": " + *problem);
    } else if (number) {
      settings_.program.feed_inputs.*rule.field = static_cast<std::int32_t>(*number);
    }
  }
  check_keys(section, keys);
}

void MachineFileReader::read_dialect(const Section& section) {
  const toml::node* const node = section.table->get("dialect");
  if (node == nullptr) {
    return;
  }
  const std::optional<std::string> name = node->value_exact<std::string>();
  if (name == "fanuc") {
    settings_.dialect = parser::Dialect::fanuc;
  } else if (name != "rs274") {
    report(node->source(), section.path_to("dialect") + ": found " +
                               (name ? in_quotes(*name) : std::string(name_of(node->type()))) +
                               ", expected 'rs274' or 'fanuc'");
  }
}

void MachineFileReader::read_path_mode(const Section& section) {
  const toml::node* const node = section.table->get("path_mode");
  if (node == nullptr) {
    return;
  }
  const std::optional<std::string> words = node->value_exact<std::string>();
  const auto control = words ? path_control_of(*words, settings_.program) : std::nullopt;
  if (control) {
    settings_.program.path_control = *control;
    return;
  }
  report(node->source(), section.path_to("path_mode") + ": found " +
                             (words ? in_quotes(*words) : std::string(name_of(node->type()))) +
                             ", expected 'G61', 'G61.1' or 'G64', which may have P and Q in mm");
}

}  // namespace kerf
