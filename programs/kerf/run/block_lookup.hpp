// Finds the lines that diagnostics are about once reading has gone past them.
#pragma once

#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "programs/kerf/io/program_file.hpp"

namespace kerf::program {

// Gives each diagnostic its block, where it has none yet: those of curves and of the machine come
// late. Reads the program and files of subprograms once more if necessary; where a file cannot be
// read, its diagnostics stay without a block.
void fill_in_blocks(std::vector<diagnostics::Diagnostic>& diagnostics, ProgramFile& program);

}  // namespace kerf::program
