#pragma once

#include <string>

namespace kerf::bench {

// How soon a feed hold shows, and how far the tool goes until it rests: on a line, a raster, the
// butterfly, a pocket and the flower, in virtual time and, after it, in real time with a busy
// machine beside it. 1 where a target is missed.
//
// folder: gets a file (write_way) of each hold whose way is more than 1.1 times the bound, or more
// than 2 % shorter than it: then it is none.
int control(const std::string& folder = {});

}  // namespace kerf::bench
