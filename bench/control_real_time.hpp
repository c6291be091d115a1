#pragma once

#include <kerf/kernel.hpp>

#include "bench/control_programs.hpp"

namespace kerf::bench {

// A row of `kerf-bench control`: holds in real time, with planning and ticks in threads of
// SCHED_FIFO and two busy threads beside them. False: a target is missed, or SCHED_FIFO is not
// allowed.
bool holds_in_real_time(const ControlProgram& program, ProfileKind profile);

}  // namespace kerf::bench
