#pragma once

namespace kerf::bench {

// How soon a feed hold shows, and how far the tool goes until it rests: on a line, a raster, the
// butterfly, a pocket and the flower, in virtual time and, behind it, in real time with a busy
// machine beside it. 1 where a target is missed.
int control();

}  // namespace kerf::bench
