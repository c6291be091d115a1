// Which settings a program can be planned with. The keys of a machine file have the same rules.
#pragma once

#include <cstdint>
#include <optional>

#include <tl/expected.hpp>

#include "diagnostics/diagnostic.hpp"
#include "kernel/kernel.hpp"
#include "kernel/settings.hpp"
#include "kernel/settings_error.hpp"

namespace kerf {

inline constexpr std::uint32_t kMaxWindowBlocks = 1'000'000;

// The first impossible value, under the name that the machine file has for it: "axes.x.max_mm". A
// limit may be infinite where it does not bind, but each of velocity, acceleration and jerk must be
// bounded along the path or on all of x, y and z, and on each further axis. Of the table's drives
// each number is looked at by itself, not whether they can do what is planned.
tl::expected<void, SettingsError> validate(const MachineSettings& settings);
tl::expected<void, SettingsError> validate(const KernelOptions& options);

// The same as Kernel reports it, at the program's first line; check_program, which plans nothing,
// lets limits be missing.
std::optional<diagnostics::Diagnostic> settings_fault(const MachineSettings& settings,
                                                      const KernelOptions& options);

// Options to rest with where those that were given are impossible: the tool stays where they say
// that it is, if they do.
KernelOptions resting_options(const KernelOptions& given);

}  // namespace kerf
