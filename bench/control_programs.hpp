// What is held, overridden and stopped in the benches of commands.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace kerf::bench {

struct ControlProgram {
  std::string name;
  std::string text;
  std::array<double, 3> start_mm{};
};

// "line" at 100 mm/s, "butterfly", and in G64 "raster", "pocket" and "flower".
std::vector<ControlProgram> control_programs();

}  // namespace kerf::bench
