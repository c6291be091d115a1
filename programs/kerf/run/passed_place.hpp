// Whether a program still leads where its run has been.
#pragma once

#include <cstdint>
#include <string>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>
#include <tl/expected.hpp>

#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

struct PassedPlace {
  std::uint64_t block = 0;  // TickDetail::block
  Position position_mm{};
};

// How far the place is from the path of its block and of those beside it, in the program as it is
// read now. Reads the file from where it stands. Precondition: it is rewound. Error: it cannot be
// read. Infinite: there is no such block.
tl::expected<double, std::string> distance_from_path_mm(ProgramFile& file,
                                                        const MachineSettings& settings,
                                                        KernelOptions options,
                                                        const PassedPlace& place);

}  // namespace kerf::program
