#pragma once

#include <cstddef>

namespace kerf::bench {

// Rests that the path does not ask for, and other degradations of the time optimum, over all runs
// of tests/kernel/smooth_runs, or every so many-th, and over real programs by others where they are
// at hand (KERF_PROGRAMS_DIR, as for the tests). 1 where there is one.
int stops(std::size_t every);

}  // namespace kerf::bench
