// A program run to its end under the eyes of the checkers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include <kerf/machine.hpp>

#include "interp/setpoint.hpp"
#include "profiles/profile.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {

struct Way {
  profiles::ProfileKind kind = profiles::ProfileKind::s_curve;
  std::size_t window_blocks = 1000;
  std::int64_t max_ticks = 3'000'000;  // more are a hang
};

struct JudgedRun {
  std::string complaint;  // the first; empty: everything holds
  interp::Setpoint last{};
  std::int64_t ticks = 0;
  std::array<double, kFigures> worst{};  // by number of Figure, over what is allowed
  double worst_chord = 0.0;              // over the tolerance
  std::uint64_t degradations = 0;
  std::uint64_t fingerprint = 0;  // of all positions and lines, to the last bit
};

// Ends with the first complaint. A program without a path and without dense points is not held
// against one; its chord error is what the kernel says.
JudgedRun judged_run(const RandomProgram& program, const MachineSettings& settings, const Way& way);

}  // namespace kerf::test
