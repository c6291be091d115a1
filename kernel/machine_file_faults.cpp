// [[driver.fault]] of a machine file.
#include <algorithm>
#include <string>

#include "kernel/machine_file_reader.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 4> kFaultKeys{"kind", "axis", "at_s", "jump_mm"};
constexpr NumberRule kAt{"at_s", 0.0, 1e9, nullptr};
constexpr NumberRule kJump{"jump_mm", -1e3, 1e3, nullptr};

// What is no text is no name of anything.
std::string text_at(const Section& section, std::string_view key) {
  const toml::node* const node = section.table->get(key);
  return node != nullptr ? node->value_exact<std::string>().value_or("?") : "";
}

}  // namespace

void MachineFileReader::read_faults(const Section& driver) {
  const toml::node* const list = driver.table->get("fault");
  if (list == nullptr) {
    return;
  }
  const bool is_none = list->is_array() && list->as_array()->empty();
  if (!is_none && !list->is_array_of_tables()) {
    report(list->source(), "driver.fault: found " + std::string(name_of(list->type())) +
                               ", expected an array of tables ([[driver.fault]])");
    return;
  }
  for (const toml::node& item : *list->as_array()) {
    read_fault({item.as_table(), "driver.fault"});
  }
  std::ranges::stable_sort(driver_.faults, {}, &PlannedFault::at_s);
}

void MachineFileReader::read_fault(const Section& section) {
  check_keys(section, kFaultKeys);
  auto fault = planned_fault({.kind = text_at(section, "kind"), .axis = text_at(section, "axis")});
  if (!fault) {
    report(section.table->source(), section.name + ": " + fault.error());
    return;
  }
  if (const toml::node* const at = section.table->get(kAt.key)) {
    fault->at_s = read_number(section, kAt, *at).value_or(0.0);
  }
  if (const toml::node* const jump = section.table->get(kJump.key)) {
    fault->jump_mm = read_number(section, kJump, *jump).value_or(0.0);
  }
  driver_.faults.push_back(*fault);
}

}  // namespace kerf
