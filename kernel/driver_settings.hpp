// What stands behind the setpoints of a run: `[driver]` of a machine file. The library drives
// nothing; the executable does (programs/kerf/driver).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/planned_fault.hpp"

namespace kerf {

inline constexpr std::array<std::string_view, 2> kDriverNames{"simulated", "loopback"};

struct DriverSettings {
  std::string name{kDriverNames.front()};
  std::string socket{};    // of loopback: the path of the one at which the machine listens
  double timeout_s = 0.1;  // of loopback: by which an answer must have come
  std::vector<PlannedFault> faults{};     // of simulated, in the order of their time
  double spindle_timeout_s = 5.0;         // by which the spindle has its speed
  std::optional<int> max_late_periods{};  // a tick that is later stops the program on the path
};

// Of a text that parse_machine_file() takes.
[[nodiscard]] DriverSettings driver_of_machine_file(std::string_view toml);

}  // namespace kerf
