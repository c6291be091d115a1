#pragma once

namespace kerf::bench {

// The time optimum in a window beside the one over the whole path, and memory beside length. 1
// where a window costs more than 2 % of time, or memory grows.
int streaming();

}  // namespace kerf::bench
