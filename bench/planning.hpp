#pragma once

namespace kerf::bench {

// How fast shipped programs and real ones by others (programs_by_others) are planned and run, and
// the longest call of Kernel::plan(). 1 where the median of those of 2,000 lines and more is below
// 50,000 lines a second, or a call takes more than 10 ms.
int planning();

}  // namespace kerf::bench
