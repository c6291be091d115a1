// One run at a time on one machine.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "programs/kerf/io/descriptor.hpp"

namespace kerf::program {

// Of the machine file, whatever its path is, and of its path, whatever file that is by now: an
// editor puts a new one there. The system releases both with the process.
struct MachineLock {
  Descriptor file;
  Descriptor name;
};

// Error: another process has one of them, or what the system says, with the file's name.
tl::expected<MachineLock, std::string> lock_machine(const std::string& machine_file);

}  // namespace kerf::program
