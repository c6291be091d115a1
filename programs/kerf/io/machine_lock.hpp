// One run at a time on one machine.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// An advisory lock on the machine file (flock), which its descriptor holds and the system releases
// with the process. Error: another process has it, or what the system says, with the file's name.
tl::expected<Descriptor, std::string> lock_machine(const std::string& machine_file);

}  // namespace kerf::program
