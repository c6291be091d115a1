#pragma once

#include <string>

namespace kerf::bench {

// A feed hold at every tick of the butterfly, and at every 37th of pocket and raster, with as many
// of the 37 remainders. Each is resumed and runs to its end. What is judged: the limits of path and
// axes from differences of ticks, the place on the path, the end to the bit. 1 where one is broken.
// name: of the program; empty: all three.
int holds(const std::string& name, int remainders);

}  // namespace kerf::bench
