// A random program under random commands.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

struct CommandedRun {
  std::string complaint{};  // the first; empty: everything holds
  std::string commands;     // what was asked for, and when
  std::int64_t ticks = 0;
  std::uint64_t fingerprint = 0;         // of all positions, to the last bit
  std::array<double, kFigures> worst{};  // TickChecker::worst
};

enum class Commands : std::uint8_t {
  all,
  override_steps,  // a feed override of 0 to 200 % every 10 ms
};

enum class Programs : std::uint8_t {
  exact,    // random_program
  milling,  // milling_program: blends and merged runs, rapids, and waits for the operator
};

// Program, profile and commands follow from the seed: holds, resumes before and after the rest,
// overrides, single block, a planning thread that is late, at the end perhaps a stop or an
// emergency stop. Judges every tick's limits, its place on the path of the run without commands
// (not of a milling program in single block, where other lines are merged), and the end.
CommandedRun commanded_run(std::uint64_t seed, Commands commands = Commands::all,
                           Programs programs = Programs::exact);

}  // namespace kerf::test
