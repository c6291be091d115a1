// Programs that people and CAM systems wrote.
#pragma once

#include <string>
#include <vector>

#include <kerf/machine.hpp>

namespace kerf::bench {

struct RealProgram {
  std::string name;
  std::string text;
  MachineSettings settings;  // the default machine, with the program's dialect
};

// Those of tests/programs.tsv that run, where they are at hand (KERF_PROGRAMS_DIR, as for the
// tests).
std::vector<RealProgram> programs_by_others();

}  // namespace kerf::bench
