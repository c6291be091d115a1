// The time optimum beside its references.
#pragma once

namespace kerf::bench {

// Every curve of programs/ from rest to rest under each set of limits of bench/optima.tsv, along
// the path and per axis, with the profiles time-optimal and s-curve, as a Markdown table. Exit
// status: 0, 1 where the time optimum is beyond a limit by more than 0.5 %, slower than 1.01 times
// the reference and the launch from rest that the reference leaves out, or planned in more than a
// tenth of its time.
int optimum();

}  // namespace kerf::bench
