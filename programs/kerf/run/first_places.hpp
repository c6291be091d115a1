// Where a program's first moves lead, for --start first-move.
#pragma once

#include <string>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

// In machine coordinates: where the rapids before the first cut bring each axis first; of a program
// that begins with a cut, where that ends. An axis that they leave alone starts as the options say.
// Reads the file from its begin and rewinds it. Error: it cannot be read, or its first moves depend
// on the start, since they are relative.
tl::expected<Position, std::string> first_places(ProgramFile& file, const MachineSettings& settings,
                                                 const KernelOptions& options);

}  // namespace kerf::program
