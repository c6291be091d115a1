#include "bench/control_programs.hpp"

#include "bench/part_programs.hpp"
#include "bench/program_text.hpp"

namespace kerf::bench {

namespace {

ControlProgram part(const std::string& name, const PartProgram& made) {
  return {.name = name,
          .text = "G21 G90 G64 P0.01 F6000\n" + made.body + "M2\n",
          .start_mm = made.start_mm};
}

}  // namespace

std::vector<ControlProgram> control_programs() {
  constexpr int kRasterMoves = 20'000;
  constexpr int kFlowerTurns = 3;
  return {{.name = "line", .text = "G21 G90\nG1 X2500 F6000\nM2\n"},
          part("raster", raster(kRasterMoves)),
          {.name = "butterfly", .text = source_file("programs/butterfly.ngc")},
          part("pocket", pocket()),
          part("flower", flower(kFlowerTurns))};
}

}  // namespace kerf::bench
