// Random programs in G64, as text.
#pragma once

#include <cstdint>

#include "tests/kernel/random_program.hpp"

namespace kerf::test {

// As random_moves() of tests/smoothing, with no path to be held against: it departs from it.
RandomProgram smoothing_program(std::uint64_t seed);

}  // namespace kerf::test
