// Checks whether a program can be planned with the settings. The keys of a machine file have the
// same rules.
#pragma once

#include <cstdint>
#include <optional>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "diagnostics/diagnostic.hpp"

namespace kerf {

inline constexpr std::uint32_t kMaxWindowBlocks = 1'000'000;

// What validate() finds, as Kernel reports it, at the program's first line. check_program, which
// plans nothing, accepts settings without limits.
std::optional<diagnostics::Diagnostic> settings_fault(const MachineSettings& settings,
                                                      const KernelOptions& options);

// Safe options in place of impossible ones: the given start position if it is valid, defaults
// otherwise.
KernelOptions resting_options(const KernelOptions& given);

}  // namespace kerf
