// What stands behind the setpoints of a run: `[driver]` of a machine file. The library drives
// nothing; the executable does (programs/kerf/driver).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace kerf {

inline constexpr std::array<std::string_view, 2> kDriverNames{"simulated", "loopback"};

struct DriverSettings {
  std::string name{kDriverNames.front()};
  std::string socket{};    // of loopback: the path of the one at which the machine listens
  double timeout_s = 0.1;  // of loopback: by which an answer must have come
  std::optional<int> max_late_periods{};  // a tick that is later stops the program on the path
};

// Of a text that parse_machine_file() takes.
[[nodiscard]] DriverSettings driver_of_machine_file(std::string_view toml);

}  // namespace kerf
