// The look at a whole program before anything moves.
#pragma once

#include <string>

#include <tl/expected.hpp>

#include "kernel/check.hpp"
#include "programs/program_file.hpp"

namespace kerf::program {

// check_program() over the file, with a progress bar if shown. Ends early, and then means nothing,
// when a stop is requested. Error: the file cannot be read.
tl::expected<CheckReport, std::string> check_pass(ProgramFile& file,
                                                  const MachineSettings& settings,
                                                  const KernelOptions& options,
                                                  bool shows_progress);

}  // namespace kerf::program
