// [program] of a machine file.
#include <array>
#include <optional>
#include <string>
#include <string_view>

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
  settings_.program.waits_for_spindle = read_flag(section, kWaitsForSpindle).value_or(false);
  read_dialect(section);
  read_path_mode(section);
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
