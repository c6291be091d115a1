// One program on one machine in one mode, to its last tick.
#pragma once

#include <cstdint>
#include <string>

#include <kerf/machine.hpp>

#include "bench/part_measure.hpp"
#include "bench/part_programs.hpp"
#include "profiles/profile.hpp"

namespace kerf::bench {

// Of each of X, Y and Z.
struct AxisSet {
  double acceleration_mm_s2 = 1000.0;
  double jerk_mm_s3 = 5e4;
};

// The default machine with these limits, 300 mm/s an axis and none along the path.
MachineSettings machine_with(const AxisSet& axes);

struct PartMode {
  std::string codes;        // "G64 P0.01 Q0.01"
  double allowed_mm = 0.0;  // how far the tool may leave what is programmed
};

struct PartRun {
  double time_s = 0.0;
  double wall_s = 0.0;  // of parsing, planning and ticks
  std::uint64_t lines = 0;
  std::uint64_t degradations = 0;
  OverLimit over{};
  Deviation deviation{};
};

// Throws where the program is refused.
PartRun run_part(const PartProgram& program, const PartMode& mode, double feed_mm_min,
                 const AxisSet& axes, profiles::ProfileKind profile);

}  // namespace kerf::bench
