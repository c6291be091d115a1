// The time optimum beside its references.
#pragma once

namespace kerf::bench {

// Every curve of programs/ from rest to rest under each set of limits of bench/optima/, along the
// path and per axis, with the profiles time-optimal and s-curve, as a Markdown table. Exit status:
// 0, 1 where the time optimum is beyond a limit by more than 0.5 %, slower than 1.01 times the
// optimum from rest, or planned in more than a tenth of its time. The references that leave out the
// jerk of launch and landing, which no motion from rest may do, are shown and do not count.
int optimum();

}  // namespace kerf::bench
