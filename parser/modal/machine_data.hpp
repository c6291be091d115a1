// What a program takes from the machine that it runs on.
#pragma once

#include <kerf/program_data.hpp>

namespace kerf::parser {

using kerf::default_program_data;
using kerf::HomePosition;
using MachineData = ProgramData;

}  // namespace kerf::parser
