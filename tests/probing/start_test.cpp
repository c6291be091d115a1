// Programs that start in the middle and ask the machine there, which answers other things than the
// simulation would.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

TableOrder from_block(std::uint64_t blocks_before) {
  TableOrder order;
  order.options.start_in_program = StartInProgram{.blocks_before = blocks_before};
  return order;
}

MachineSettings exact_machine() {
  MachineSettings settings = default_machine();
  settings.program.path_control = {};
  return settings;
}

double lowest_mm(const TableRun& run) {
  return std::ranges::min(run.ticks, {}, [](const Setpoint& tick) { return tick.position_mm[2]; })
      .position_mm[2];
}

// Found by reading: the reader was told to ask only once the first part of the path had left the
// smoother, which has read what comes after it by then.
TEST(StartWithQuestions, AProbeAtTheStartOrRightBehindItEndsAtItsContact) {
  for (const std::string mode : {"G61", "G64 P0.01"}) {
    for (const std::uint64_t blocks_before : {2U, 3U, 4U, 5U}) {
      SCOPED_TRACE(mode + " " + std::to_string(blocks_before));
      TableOrder order = from_block(blocks_before);
      order.before = [](Kernel&, const TableRun& run, ProgramInputs& inputs) {
        inputs.probe = !run.ticks.empty() && run.ticks.back().position_mm[2] <= -3.0;
      };
      const TableRun run =
          run_on_table(exact_machine(),
                       "G21 G90 " + mode +
                           "\nG0 X1 Z5\nG1 X5 F2000\nG1 X6\nX7\nG38.2 Z-15 F900\nG0 Z5\nG1 X8 "
                           "F2000\nM2\n",
                       order);
      EXPECT_EQ(run.status, TickStatus::finished);
      EXPECT_EQ(run.complaint, "");
      EXPECT_LT(lowest_mm(run), -3.0);
      EXPECT_GT(lowest_mm(run), -4.0);
      EXPECT_EQ(run.ticks.back().position_mm, (Position{8.0, 0.0, 5.0}));
    }
  }
}

TEST(StartWithQuestions, AnInputIsReadWhereTheProgramAsksForIt) {
  for (const std::uint64_t blocks_before : {1U, 3U, 4U}) {
    TableOrder order = from_block(blocks_before);
    order.before = [](Kernel&, const TableRun&, ProgramInputs& inputs) {
      inputs.digital = 1U << 3U;
    };
    const TableRun run = run_on_table(
        default_machine(), "G21 G90\nG1 X1 F600\nX2\nX3\nM66 P3 L0\nG1 X[10+#5399]\nM2\n", order);
    EXPECT_EQ(run.status, TickStatus::finished) << blocks_before;
    EXPECT_EQ(run.ticks.back().position_mm[0], 11.0) << blocks_before;
  }
}

// Found by reading: the answer to the question of the way was given to the reader, which had not
// asked, and the path after it began elsewhere.
TEST(StartWithQuestions, TheToolWaitsForTheSpindleAboveTheStart) {
  MachineSettings settings = exact_machine();
  settings.program.waits_for_spindle = true;
  settings.program.safe_z_mm = 20.0;
  for (const char* behind : {"", "M66 P3 L0\n"}) {
    TableOrder order = from_block(3);
    std::int64_t turned = -1;
    order.before = [&turned](Kernel&, const TableRun& run, ProgramInputs& inputs) {
      if (turned < 0 && !run.ticks.empty() && run.ticks.back().outputs.spindle_rad_s != 0.0) {
        turned = run.ticks.back().tick;
      }
      inputs.spindle_at_speed = turned >= 0 && run.ticks.back().tick > turned + 400;
    };
    const TableRun run =
        run_on_table(settings,
                     std::string("G21 G90 G61\nM3 S1000\nG1 X10 F600\nG1 X20\nG91\nG1 X5\n") +
                         behind + "G1 X5\nG90\nG1 Y7\nM2\n",
                     order);
    EXPECT_EQ(run.status, TickStatus::finished);
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.ticks.back().position_mm, (Position{30.0, 7.0, 0.0}));
    const auto goes_over = std::ranges::find_if(
        run.ticks, [](const Setpoint& tick) { return tick.position_mm[0] > 0.0; });
    EXPECT_GT(goes_over->tick, turned + 400);
  }
}

}  // namespace
}  // namespace kerf::test
