// The machine that the command line names.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "kernel/settings.hpp"
#include "programs/exit_status.hpp"

namespace kerf::program {

struct MachineRefusal {
  ExitStatus status = ExitStatus::settings_error;  // or io_error: the file cannot be read
  std::vector<std::string> messages;  // with file, line and column where there is a place
};

// Without a file the default table.
tl::expected<MachineSettings, MachineRefusal> choose_machine(
    const std::optional<std::string>& machine_file);

}  // namespace kerf::program
