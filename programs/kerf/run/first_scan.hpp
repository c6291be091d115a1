// The scan of the first curve of a program, for its plot.
#pragma once

#include <optional>

#include <kerf/kernel.hpp>
#include <kerf/machine.hpp>

#include "programs/kerf/io/program_file.hpp"
#include "programs/kerf/plot/scanned_curve.hpp"

namespace kerf::program {

// Reads the file from where it stands to its first NURBS. Nothing: there is none, or it is no curve
// but a line.
std::optional<ScannedCurve> first_scan(ProgramFile& file, const MachineSettings& settings,
                                       const KernelOptions& options);

}  // namespace kerf::program
