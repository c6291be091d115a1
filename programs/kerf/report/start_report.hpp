// Where a program starts that does not start at its begin.
#pragma once

#include <cstdint>
#include <string>

#include "parser/flow/block_watcher.hpp"

namespace kerf::program {

// A line of a program, at one of the times that it runs.
struct LineRound {
  std::string file{};  // of a subprogram; empty: the program's own
  std::uint32_t line = 0;
  std::uint64_t round = 1;          // the first time it runs, the second, ...
  std::uint64_t blocks_before = 0;  // of the program's run
};

struct StartReport {
  LineRound place;
  parser::WatchedBlock block;
  // Of the first M66 before it whose answer nobody knows, so that [simulation] gives one; 0: none.
  std::uint32_t assumed_input_line = 0;
};

// "line 12"; "line 12:3", as it runs for the third time; "line 4 of pocket.ngc".
[[nodiscard]] std::string name_of(const LineRound& place);

}  // namespace kerf::program
