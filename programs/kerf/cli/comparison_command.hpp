// `kerf compare`: two programs, or one on two machines.
#pragma once

#include <vector>

#include "programs/kerf/cli/machine_choice.hpp"
#include "programs/kerf/exit_status.hpp"
#include "programs/kerf/options.hpp"

namespace kerf::program {

// Precondition: two programs or two machines; of what is there once, both take that one.
ExitStatus compare(const Options& options, const std::vector<NamedMachine>& machines);

}  // namespace kerf::program
