// A random program under random commands.
#pragma once

#include <cstdint>
#include <string>

namespace kerf::test {

struct CommandedRun {
  std::string complaint{};  // the first; empty: everything holds
  std::string commands;     // what was asked for, and when
  std::int64_t ticks = 0;
  std::uint64_t fingerprint = 0;  // of all positions, to the last bit
};

// Program, profile and commands follow from the seed: holds, resumes before and after the rest,
// overrides, single block, a planning thread that is late, at the end perhaps a stop or an
// emergency stop. Judges every tick's limits, its place on the path of the run without commands,
// and the end.
CommandedRun commanded_run(std::uint64_t seed);

}  // namespace kerf::test
