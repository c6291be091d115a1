// Random curves and programs, judged tick by tick.
#pragma once

#include <cstdint>

namespace kerf::bench {

enum class SoakKind : std::uint8_t {
  mixed,       // curves and programs of few blocks
  smoothed,    // short lines in G64, whose deviation is judged, too
  degenerate,  // moves that are as good as none among ordinary ones
  control,     // an operator's commands at random ticks; of every 41st program overrides alone
  milling,     // the same in programs with blends, merged runs, rapids and waits
};

struct Soak {
  std::uint64_t seed = 1;  // the first
  std::uint64_t last = 0;  // all up to that one, and as many more as the seconds allow
  double seconds = 0.0;
  SoakKind kind = SoakKind::mixed;
  bool fingerprints = false;  // prints each program's ticks and their fingerprint
};

// Prints the seed of each failure, the count, and the largest of each figure over its limit.
// 1 where something failed. A program that takes a minute is a failure that ends the process.
int soak(const Soak& order);

}  // namespace kerf::bench
