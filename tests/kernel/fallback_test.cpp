// Rows of short lines under limits four decades apart, on which the time optimum is not found from
// rest: the plan of the S-curve stands in.
#include <gtest/gtest.h>

#include "tests/kernel/judged_run.hpp"
#include "tests/kernel/random_machine.hpp"

namespace kerf::test {
namespace {

using profiles::ProfileKind;

// Slowed down as a whole, or cut by rests, they took up to twice the time.
TEST(Fallback, TakesHardlyLongerThanTheSCurveWhereTheOptimumIsNotFound) {
  for (const std::uint64_t seed : {2000299U, 2002504U, 2002658U}) {
    SCOPED_TRACE(seed);
    const MachineSettings settings = random_machine(seed, Spread::wide);
    const RandomProgram program =
        random_program(seed, {.arcs = seed % 4 != 0,
                              .nurbs = false,
                              .contour = true,
                              .blocks = 60,
                              .longest_mm = std::min(1e3, unhurried_mm(settings))});
    Way way{.kind = ProfileKind::time_optimal};
    const JudgedRun optimum = judged_run(program, settings, way);
    way.kind = ProfileKind::s_curve;
    const JudgedRun classical = judged_run(program, settings, way);
    EXPECT_EQ(optimum.complaint, "");
    EXPECT_EQ(optimum.last.position_mm, program.end_mm);
    EXPECT_LT(static_cast<double>(optimum.ticks), 1.1 * static_cast<double>(classical.ticks));
  }
}

}  // namespace
}  // namespace kerf::test
