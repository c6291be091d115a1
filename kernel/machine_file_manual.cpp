// [manual] of a machine file.
#include "kernel/machine_file_reader.hpp"

namespace kerf {

void MachineFileReader::read_manual(const Section& section) {
  constexpr std::string_view kRunsUnhomed = "runs_unhomed";
  std::vector<std::string_view> keys{kRunsUnhomed};
  for (const NumberRule& rule : manual_rules()) {
    keys.push_back(rule.key);
    const toml::node* const node = section.table->get(rule.key);
    if (const auto number = node != nullptr ? read_number(section, rule, *node) : std::nullopt) {
      rule.field(settings_, 0) = *number;
    }
  }
  check_keys(section, keys);
  read_truth(section, kRunsUnhomed, settings_.manual.runs_unhomed);
}

}  // namespace kerf
