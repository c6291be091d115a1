// Random programs in which moves of 1e-320 to 1e-6 mm stand among ordinary ones.
#pragma once

#include <cstdint>

#include "tests/kernel/random_program.hpp"

namespace kerf::test {

// Tiny moves by literals, expressions, offsets, turned offsets, a change of unit and incremental
// sums; as lines, rapids, arcs, helices, splines, moves of A and U and cycles; alone and in runs of
// up to 10,000, before and after each kind of ordinary block; in G61, G61.1 and G64. For a machine
// of random_machine(). `end_mm` is where the program says, added up on its own account.
RandomProgram degenerate_program(std::uint64_t seed);

// How far from its end a program of tiny moves may come to rest: what is too short is not run, and
// the sums round.
inline constexpr double kDegenerateEnd_mm = 1.1e-10;

}  // namespace kerf::test
