#pragma once

#include <optional>
#include <string>

#include <kerf/profile.hpp>

namespace kerf::bench {

struct HoldsOrder {
  std::string only;                      // program; empty: all three
  std::optional<ProfileKind> profile{};  // none: time optimum and S-curve
  int first = 0;                         // of the 37 remainders
  int last = 0;
};

// A feed hold at every tick of the butterfly, and at every 37th of pocket and raster, once for each
// remainder: all 37 are every tick. Each is resumed and runs to its end. What is judged: the limits
// of path and axes from differences of ticks, the place on the path, the end to the bit. 1 where
// one is broken.
int holds(const HoldsOrder& order);

}  // namespace kerf::bench
