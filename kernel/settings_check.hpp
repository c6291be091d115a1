// Which settings a program can be planned with. The keys of a machine file have the same rules.
#pragma once

#include <cstdint>
#include <optional>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "diagnostics/diagnostic.hpp"

namespace kerf {

inline constexpr std::uint32_t kMaxWindowBlocks = 1'000'000;

// What validate() finds, as Kernel reports it, at the program's first line; check_program, which
// plans nothing, lets limits be missing.
std::optional<diagnostics::Diagnostic> settings_fault(const MachineSettings& settings,
                                                      const KernelOptions& options);

// Options to rest with where those that were given are impossible: the tool stays where they say
// that it is, if they do.
KernelOptions resting_options(const KernelOptions& given);

}  // namespace kerf
