// The time optimum held against classical profiles, on the programs of the soak.
#pragma once

#include <cstdint>
#include <string>

#include "bench/soak_trials.hpp"

namespace kerf::bench {

struct Slower {
  std::uint64_t compared = 0;
  std::uint64_t programs = 0;
  std::int64_t worst_ticks = 0;
  double worst_ratio = 1.0;
};

// What a classical profile takes for a program that the time optimum ran in so many ticks. Where
// the optimum is slower by more than a tick, that is printed and counted. The complaint, empty if
// there is none, is of more than a hundredth and a tick, in windows of a usual size: those of a few
// blocks brake for their end again and again, each schedule at other places.
std::string compare(std::uint64_t seed, const Trial& trial, std::int64_t ticks, Slower& slower);

}  // namespace kerf::bench
