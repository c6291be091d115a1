// M66 waits for the machine's inputs.
#include <cstdint>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

using Level = std::function<bool(std::size_t tick)>;

struct Waited {
  double answer = 0.0;  // #5399
  std::size_t ticks = 0;
};

// Input 5 as `level` says; a way of 1 mm comes before the wait.
Waited wait(const std::string& words, const Level& level) {
  TableOrder order;
  order.before = [&](Kernel& /*kernel*/, const TableRun& run, ProgramInputs& inputs) {
    inputs.digital = level(run.ticks.size()) ? 1U << 5U : 0U;
    inputs.analog[2] = 1.25;
  };
  const TableRun run = whole_run(
      default_machine(), "G21 G61 F600\nG1 X1\nM66 " + words + "\nG0 Y[10 + #5399]\nM2\n", order);
  std::size_t ticks = 0;
  for (const Setpoint& tick : run.ticks) {
    ticks += tick.position_mm[0] == 1.0 && tick.position_mm[1] == 0.0 ? 1U : 0U;
  }
  return {.answer = run.ticks.back().position_mm[1] - 10.0, .ticks = ticks};
}

const Level kLow = [](std::size_t /*tick*/) { return false; };
const Level kHigh = [](std::size_t /*tick*/) { return true; };
const Level kHighFrom500 = [](std::size_t tick) { return tick >= 500; };
const Level kLowFrom500 = [](std::size_t tick) { return tick < 500; };

constexpr std::size_t kPause = 50;  // after an answer
constexpr std::size_t kBeside = 4;  // where the tool comes and goes

TEST(Inputs, AtOnceIsTheInputAtThatTime) {
  const Waited low = wait("P5 L0", kLow);
  EXPECT_EQ(low.answer, 0.0);
  EXPECT_NEAR(static_cast<double>(low.ticks), kPause, kBeside);
  EXPECT_EQ(wait("P5 L0", kHigh).answer, 1.0);
  EXPECT_EQ(wait("P5", kHigh).answer, 1.0);
  EXPECT_EQ(wait("E2", kLow).answer, 1.25);
}

TEST(Inputs, ALevelOrAnEdgeIsWaitedFor) {
  EXPECT_EQ(wait("P5 L3 Q9", kHighFrom500).answer, 1.0);
  EXPECT_EQ(wait("P5 L1 Q9", kHighFrom500).answer, 1.0);
  EXPECT_EQ(wait("P5 L4 Q9", kLowFrom500).answer, 0.0);
  EXPECT_EQ(wait("P5 L2 Q9", kLowFrom500).answer, 0.0);
  const std::size_t before = wait("P5 L0", kLow).ticks;
  const Waited waited = wait("P5 L3 Q9", kHighFrom500);
  // The way before takes less than 300 ticks: it comes to rest, and waits until tick 500.
  EXPECT_GT(waited.ticks, before + 200);
  EXPECT_LT(waited.ticks, before + 500);
}

TEST(Inputs, ALevelThatIsThereIsNoEdge) {
  EXPECT_EQ(wait("P5 L3 Q0.2", kHigh).answer, 1.0);
  EXPECT_EQ(wait("P5 L1 Q0.2", kHigh).answer, -1.0);
  EXPECT_EQ(wait("P5 L4 Q0.2", kLow).answer, 0.0);
  EXPECT_EQ(wait("P5 L2 Q0.2", kLow).answer, -1.0);
}

TEST(Inputs, AWaitInVainLastsAsLongAsItSays) {
  const std::size_t at_once = wait("P5 L0", kLow).ticks;
  const Waited vain = wait("P5 L3 Q0.2", kLow);
  EXPECT_EQ(vain.answer, -1.0);
  EXPECT_EQ(vain.ticks, at_once - 1 + 200);  // an input is read a tick after the rest
}

TEST(Inputs, AHoldInAWaitComesBehindItWithAnOverrideOrNot) {
  for (const bool overrides : {false, true}) {
    TableOrder order;
    std::size_t held = 0;
    order.before = [&](Kernel& kernel, const TableRun& run, ProgramInputs& inputs) {
      inputs.digital = run.ticks.size() >= 800 ? 1U << 5U : 0U;
      held += run.status == TickStatus::held ? 1U : 0U;
      if (run.ticks.size() == 500) {
        kernel.hold();
        EXPECT_TRUE(!overrides || kernel.set_overrides({.feed = 0.5}));
      } else if (run.ticks.size() == 1200) {
        kernel.resume();
      }
    };
    const TableRun run = whole_run(
        default_machine(), "G21 G61 F600\nG1 X1\nM66 P5 L3 Q9\nG0 Y[10 + #5399]\nM2\n", order);
    EXPECT_EQ(run.ticks.back().position_mm[1], 11.0);
    EXPECT_GT(held, 300u);
    EXPECT_LT(held, 401u);
  }
}

TEST(Inputs, AStopInAWaitEndsTheProgram) {
  TableOrder order;
  order.before = [](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
    if (run.ticks.size() == 500) {
      kernel.stop();
    }
  };
  const TableRun run =
      run_on_table(default_machine(), "G21 G61 F600\nG1 X1\nM66 P5 L3 Q9\nG0 Y10\nM2\n", order);
  EXPECT_EQ(run.status, TickStatus::finished);
  EXPECT_EQ(run.complaint, "");
  EXPECT_LT(run.ticks.size(), 600u);
  EXPECT_EQ(run.ticks.back().position_mm, (Position{1.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace kerf::test
