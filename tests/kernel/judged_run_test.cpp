// The chord of a tick over a corner that is passed at its lowest feedrate.
#include "tests/kernel/judged_run.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace kerf::test {
namespace {

// The corner allows 3 mm/s by its chord error, and at 1e6 mm/s^3 a tick around the least feedrate
// is 1.4 % longer than at that feedrate.
TEST(ChordOverACorner, HoldsWhereTheToolBrakesAndSpeedsUpAgain) {
  MachineSettings settings;
  settings.limits.path = {.velocity_mm_s = 100.0, .acceleration_mm_s2 = 300.0, .jerk_mm_s3 = 1e6};
  settings.limits.axes.fill(settings.limits.path);
  settings.limits.chord_tolerance_mm = 1.5e-5;
  double largest = 0.0;  // of all places that the corner has between two ticks
  for (int k = 0; k < 40; ++k) {
    RandomProgram program;
    const Vec corner{1.0 + 1e-3 * k, 0.0, 0.0};
    const Vec end{2.0, 0.02, 0.0};
    program.text = "G21 G90 G94\nG1 X" + std::to_string(corner[0]) + " F3000\nX2 Y0.02\nM2\n";
    program.end_mm = end;
    program.feedrate_mm_s.assign(4, 50.0);
    program.path = {line_stretch({}, {corner}), line_stretch({corner}, end)};
    program.path[0].line = 2;
    program.path[1].line = 3;
    const JudgedRun run =
        judged_run(program, settings, {.kind = profiles::ProfileKind::time_optimal});
    EXPECT_EQ(run.complaint, "");
    largest = std::max(largest, run.worst_chord);
  }
  EXPECT_LE(largest, 1.0 + 1e-3);
  EXPECT_GE(largest, 0.97);  // passed, and no slower than need be
}

}  // namespace
}  // namespace kerf::test
