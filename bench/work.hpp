#pragma once

#include <cstdint>
#include <string>

namespace kerf::bench {

// What callgrind dumps its counts after: each tick, or each call of Kernel::plan.
enum class Counted : std::uint8_t { ticks, windows };

// One shipped (butterfly, ...) or singular curve (tests/kernel/singular_curves.hpp), run once at
// the time optimum: what bench/count_work counts instructions of. Prints the number of ticks.
int work(const std::string& curve, Counted counted);

}  // namespace kerf::bench
