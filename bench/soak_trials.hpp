// The random programs of the soak.
#pragma once

#include <cstdint>
#include <string>

#include <kerf/machine.hpp>

#include "bench/soak.hpp"
#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_program.hpp"

namespace kerf::bench {

struct Trial {
  test::RandomProgram program;
  MachineSettings settings;
  test::Way way;
};

Trial trial_of(std::uint64_t seed, SoakKind kind);

// What is wrong with the path of a smoothed trial; empty: it has no gap and stays within the
// tolerances.
std::string deviation_complaint(std::uint64_t seed);

}  // namespace kerf::bench
