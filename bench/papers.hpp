// The published results beside ours.
#pragma once

namespace kerf::bench {

// Prints the tables as Markdown on standard output. Exit status: 0, 1 where a target is missed.
int papers();

}  // namespace kerf::bench
