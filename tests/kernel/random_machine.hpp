// Random limits for random programs.
#pragma once

#include <cstdint>

#include <kerf/machine.hpp>

namespace kerf::test {

enum class Spread : std::uint8_t {
  common,  // as machines have it
  wide     // velocity, acceleration and jerk each over four decades between axes
};

// With axes A and U beside X, Y and Z, and for half of the seeds limits along the path.
MachineSettings random_machine(std::uint64_t seed, Spread spread);

// The way that the slowest of X, Y and Z covers in 2 s: for lines that end in bounded time.
double unhurried_mm(const MachineSettings& settings);

}  // namespace kerf::test
