// [driver] of a machine file.
#include <algorithm>

#include "kernel/driver_settings.hpp"
#include "kernel/machine_file_reader.hpp"
#include "kernel/machine_file_text.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 2> kDriverKeys{"name", "max_late_periods"};
constexpr NumberRule kMaxLatePeriods{"max_late_periods", 1.0, 100'000.0, nullptr};

std::string known_drivers() {
  std::string names;
  for (const std::string_view name : kDriverNames) {
    names += (names.empty() ? "" : name == kDriverNames.back() ? " or " : ", ") + in_quotes(name);
  }
  return names;
}

}  // namespace

void MachineFileReader::read_driver(const Section& section) {
  check_keys(section, kDriverKeys);
  if (const toml::node* const late = section.table->get(kMaxLatePeriods.key)) {
    if (const auto number = read_number(section, kMaxLatePeriods, *late)) {
      driver_.max_late_periods = static_cast<int>(*number);
    }
  }
  const toml::node* const node = section.table->get("name");
  if (node == nullptr) {
    return;
  }
  const std::optional<std::string> name = node->value_exact<std::string>();
  if (name && std::find(kDriverNames.begin(), kDriverNames.end(), *name) != kDriverNames.end()) {
    driver_.name = *name;
    return;
  }
  report(node->source(), section.path_to("name") + ": found " +
                             (name ? in_quotes(*name) : std::string(name_of(node->type()))) +
                             ", expected " + known_drivers());
}

DriverSettings driver_of_machine_file(std::string_view toml) {
  const toml::parse_result parsed = toml::parse(toml);
  MachineFileReader reader;
  if (!parsed || !reader.read(parsed.table())) {
    return {};
  }
  return reader.driver();
}

}  // namespace kerf
