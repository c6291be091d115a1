// Random programs in G64, G61 and G61.1, as text.
#pragma once

#include <cstdint>

#include "tests/kernel/random_program.hpp"
#include "tests/smoothing/polylines.hpp"

namespace kerf::test {

// One of 64 is a full one.
RandomMoves smoothing_moves(std::uint64_t seed);

// These moves, with no path to be held against: it departs from it.
RandomProgram smoothing_program(std::uint64_t seed);

// The same with what stands between moves: rapids, dwells, stops, outputs, speeds of the spindle,
// some of them in G95.
RandomProgram milling_program(std::uint64_t seed);

}  // namespace kerf::test
