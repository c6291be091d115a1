// Ends the process where something does not hold, as a fuzzer and a debugger like it.
#pragma once

#include <cstdio>
#include <cstdlib>

namespace kerf::fuzz {

inline void require(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "this does not hold: %s\n", what);
    std::abort();
  }
}

}  // namespace kerf::fuzz
