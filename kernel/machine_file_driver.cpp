// [driver] of a machine file.
#include <algorithm>
#include <cmath>

#include "kernel/driver_settings.hpp"
#include "kernel/machine_file_reader.hpp"
#include "kernel/machine_file_text.hpp"

namespace kerf {

namespace {

constexpr std::array<std::string_view, 6> kDriverKeys{
    "name", "socket", "timeout_s", "spindle_timeout_s", "fault", "max_late_periods"};
constexpr NumberRule kMaxLatePeriods{"max_late_periods", 1.0, 100'000.0, nullptr};
constexpr NumberRule kSpindleTimeout{"spindle_timeout_s", 0.0, 3600.0, nullptr};
constexpr NumberRule kTimeout{"timeout_s", 1e-4, 10.0, nullptr};

std::string known_drivers() {
  std::string names;
  for (const std::string_view name : kDriverNames) {
    names += (names.empty() ? "" : name == kDriverNames.back() ? " or " : ", ") + in_quotes(name);
  }
  return names;
}

}  // namespace

void MachineFileReader::read_max_late_periods(const Section& section) {
  const toml::node* const late = section.table->get(kMaxLatePeriods.key);
  const auto number = late != nullptr ? read_number(section, kMaxLatePeriods, *late) : std::nullopt;
  if (number && *number != std::floor(*number)) {
    report(late->source(), section.path_to(kMaxLatePeriods.key) + ": expected a whole number");
  } else if (number) {
    driver_.max_late_periods = static_cast<int>(*number);
  }
}

void MachineFileReader::read_driver(const Section& section) {
  check_keys(section, kDriverKeys);
  read_max_late_periods(section);
  if (const toml::node* const timeout = section.table->get(kTimeout.key)) {
    driver_.timeout_s = read_number(section, kTimeout, *timeout).value_or(driver_.timeout_s);
  }
  if (const toml::node* const spindle = section.table->get(kSpindleTimeout.key)) {
    driver_.spindle_timeout_s =
        read_number(section, kSpindleTimeout, *spindle).value_or(driver_.spindle_timeout_s);
  }
  read_faults(section);
  if (const toml::node* const socket = section.table->get("socket")) {
    driver_.socket = socket->value_exact<std::string>().value_or("");
    if (driver_.socket.empty()) {
      report(socket->source(), section.path_to("socket") + ": expected the path of a socket");
    }
  }
  const toml::node* const node = section.table->get("name");
  if (node == nullptr) {
    return;
  }
  const std::optional<std::string> name = node->value_exact<std::string>();
  if (name && std::find(kDriverNames.begin(), kDriverNames.end(), *name) != kDriverNames.end()) {
    driver_.name = *name;
    if (*name == "loopback" && !section.table->contains("socket")) {
      report(node->source(), section.path_to("name") + ": the driver loopback needs a socket");
    }
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
