// The machine that the command line names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "kernel/driver_settings.hpp"
#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/options.hpp"

namespace kerf::program {

struct MachineRefusal {
  ExitStatus status = ExitStatus::settings_error;  // or io_error: the file cannot be read
  std::vector<std::string> messages;  // with file, line and column where there is a place
};

// What the command line names; without a machine file it is the default table.
struct MachineOrder {
  std::optional<std::string> file;
  std::optional<std::string> tools;  // in place of the machine's tool table
  std::optional<Position> g54_mm;    // in place of the machine's
};

struct ChosenMachine {
  MachineSettings settings;
  DriverSettings driver{};
  std::uint64_t checksum = 0;  // of the texts of the files, and of G54 where the order has it
};

// A tool table or height map that the machine file names is looked for beside it; `named` gets
// their paths, also where they are refused.
tl::expected<ChosenMachine, MachineRefusal> choose_machine(const MachineOrder& order,
                                                           std::vector<std::string>& named);

struct NamedMachine {
  std::optional<std::string> file;
  ChosenMachine chosen;
};

// All that the options name, in their order; without any the default table. `named` as above.
tl::expected<std::vector<NamedMachine>, MachineRefusal> choose_machines(
    const Options& options, std::vector<std::string>& named);

// The options of a program that runs on this machine.
[[nodiscard]] Options options_on(const NamedMachine& machine, const Options& options);

}  // namespace kerf::program
