// A tool whose length is known only once it is in the spindle.
#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

// Changes the tool where M6 waits, and answers.
TableOrder changing_to(double length_mm) {
  TableOrder order{.options = {.waits = true}};
  order.before = [length_mm](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
    if (run.status == TickStatus::waiting) {
      EXPECT_TRUE(kernel.set_tool({.number = 2, .pocket = 2, .offset_mm = {0.0, 0.0, length_mm}}));
      kernel.resume();
    }
  };
  return order;
}

constexpr const char* kProgram =
    "G21 G61 G90 F600\nG1 X5\nT2 M6\nG43 H2\nG1 Z1\nG64 P0.1\nX10\nX20 Z2\nX30 Z1\nM2\n";

TEST(ToolChange, AllBehindItIsPlannedWithTheLengthOfTheToolThatCame) {
  for (const double length_mm : {0.0, 7.0, -3.5}) {
    const TableRun run = whole_run(default_machine(), kProgram, changing_to(length_mm));
    double highest_mm = 0.0;
    for (const Setpoint& tick : run.ticks) {
      highest_mm = std::max(highest_mm, tick.position_mm[2]);
    }
    EXPECT_EQ(run.ticks.back().position_mm, (Position{30.0, 0.0, 1.0 + length_mm}));
    EXPECT_LE(highest_mm, std::max(2.0 + length_mm, 0.0));
  }
}

TEST(ToolChange, ALengthThatLeadsBeyondTheTravelEndsTheProgramAtRestBeforeThat) {
  for (const double length_mm : {300.0, -300.0}) {  // of z from -200 to 200
    const TableRun run = run_on_table(default_machine(), kProgram, changing_to(length_mm));
    EXPECT_EQ(run.status, TickStatus::failed);
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.ticks.back().position_mm, (Position{5.0, 0.0, 0.0}));
    ASSERT_EQ(run.errors.size(), 1U);
    EXPECT_EQ(run.errors.front(), length_mm > 0.0
                                      ? "5: z goes 101 mm beyond its upper limit of 200 mm"
                                      : "5: z goes 99 mm beyond its lower limit of -200 mm");
  }
}

TEST(ToolChange, AToolThatCannotBeIsRefused) {
  Kernel kernel(default_machine());
  EXPECT_FALSE(kernel.set_tool({.number = -1}));
  EXPECT_FALSE(kernel.set_tool({.number = 2, .offset_mm = {0.0, 0.0, 1e300}}));
  EXPECT_FALSE(kernel.set_tool({.number = 2, .diameter_mm = -1.0}));
}

}  // namespace
}  // namespace kerf::test
