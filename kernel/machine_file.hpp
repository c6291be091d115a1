// The machine file: TOML, every key documented, checked and named with line and column if wrong.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/settings.hpp"
#include "kernel/settings_error.hpp"

namespace kerf {

// "file:line:column: error: message", or "file: error: message" where no place is to blame.
std::string to_string(const SettingsError& error, std::string_view file);

// The schema is in docs/machine-file.md. What the text leaves out keeps the defaults of the
// structs, the limits of a plan then do not bind. All errors are returned, in the order of the text
// (of a text that is not TOML only the first, and nothing else).
//
// Errors: not TOML, unknown key, wrong type, impossible value, a limit that nothing bounds (each of
// velocity, acceleration and jerk needs a value along the path or on all three axes), min_mm not
// below max_mm, a drive weaker than the axis' limits, a position loop faster than the velocity
// loop, over 1 MiB.
tl::expected<MachineSettings, std::vector<SettingsError>> parse_machine_file(std::string_view toml);

// The default table: what programs/machines/table.toml says, without a file.
MachineSettings default_machine();

}  // namespace kerf
