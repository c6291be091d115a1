// The machine that a run drives, by its name.
#pragma once

#include <memory>
#include <string>

#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "kernel/driver_settings.hpp"
#include "machine/machine.hpp"

namespace kerf::program {

// Not enabled yet. Error: why there is none.
[[nodiscard]] tl::expected<std::unique_ptr<machine::Machine>, std::string> open_driver(
    const DriverSettings& driver, const MachineSettings& settings);

}  // namespace kerf::program
