// The machine file: TOML, every key documented, checked and named with line and column if wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/settings.hpp"

namespace kerf {

struct SettingsError {
  unsigned line = 0;  // 1-based; 0 where no place is to blame
  unsigned column = 0;
  std::string message;
};

std::string to_string(const SettingsError& error, std::string_view file);

// Errors: not TOML, unknown key, wrong type, impossible value, a limit that nothing bounds (each of
// velocity, acceleration and jerk needs a value along the path or on all three axes), over 1 MiB.
tl::expected<MachineSettings, std::vector<SettingsError>> parse_machine_file(std::string_view toml);

// The default table: what programs/machines/table.toml says, without a file.
MachineSettings default_machine();

}  // namespace kerf
