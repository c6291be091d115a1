// Commands of an operator while a program asks the machine.
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

// Before a trip, between it and the answer, in the rest after it, and in a wait for an input.
TEST(ProbeCommands, AHoldAndAnOverrideMayComeAtAnyTick) {
  const MachineSettings settings = touching(TouchPlane{.point_mm = {0.0, 0.0, -2.0}}, false);
  const std::string text =
      "G21 G61 G90 F3000\nG38.2 Z-5 F600\nG38.5 Z5 F600\nM66 P1 L3 Q0.1\nG1 Z8\nM2\n";
  const TableRun alone = whole_run(settings, text);
  for (std::size_t tick = 1; tick < alone.ticks.size(); tick += 6) {
    for (const std::size_t later : {0U, 12U}) {
      SCOPED_TRACE("tick " + std::to_string(tick) + ", " + std::to_string(later) + " later");
      TableOrder order;
      order.before = [&](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
        const std::size_t now = run.ticks.size();
        if (now == tick) {
          kernel.hold();
        }
        if (now == tick + later) {
          EXPECT_TRUE(kernel.set_overrides({.feed = 0.7}));
        }
        if (now == tick + 60) {
          kernel.resume();
        }
        if (now == 2 * alone.ticks.size()) {
          kernel.stop();  // it hangs
        }
      };
      const TableRun run = whole_run(settings, text, order);
      ASSERT_EQ(run.ticks.back().position_mm, alone.ticks.back().position_mm);
      ASSERT_FALSE(HasFailure());
    }
  }
}

// The wait after a block comes before that for the machine, which is asked by then.
TEST(ProbeCommands, InSingleBlockEachBlockIsResumedAndTheMachineStillAnswers) {
  const MachineSettings settings = touching(TouchPlane{.point_mm = {0.0, 0.0, -2.0}}, true);
  const std::string text =
      "G21 G61 G90 F3000\nG1 X1\nM66 P1 L3 Q0.1\nG38.2 Z-5 F600\nM66 E0 L0\nG1 Z8\nM2\n";
  int waits = 0;
  TableOrder order;
  order.options.waits = true;
  order.before = [&waits](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
    if (run.ticks.empty()) {
      kernel.set_single_block(true);
    }
    if (run.status == TickStatus::waiting) {
      kernel.resume();
      ++waits;
    }
    if (run.ticks.size() == 20'000) {
      kernel.stop();  // it hangs
    }
  };
  const TableRun run = whole_run(settings, text, order);
  EXPECT_EQ(run.ticks.back().position_mm, (Position{1.0, 0.0, 8.0}));
  EXPECT_GE(waits, 4);
}

}  // namespace
}  // namespace kerf::test
