// The walls in front of all limits.
#pragma once

namespace kerf::lookahead {

// How sharp the walls are.
struct Walls {
  double weight_s = 0.0;     // of each
  double stiffness_s = 0.0;  // stands for the weight in the second derivatives
  double relaxed = 0.0;      // Barrier
};

}  // namespace kerf::lookahead
