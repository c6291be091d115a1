// What G38.2 to G38.5 give a program, and how they fail, on the simulated table.
#include <string>

#include <gtest/gtest.h>

#include "tests/probing/table_run.hpp"

namespace kerf::test {
namespace {

// The top at Z-10.
MachineSettings table_top(bool latches = true) {
  TouchBox box;
  box.max_mm[2] = -10.0;
  return touching(box, latches);
}

Position end_of(const TableRun& run) {
  return run.ticks.back().position_mm;
}

TEST(ProbeCodes, AContactEndsTheMoveAndTheProgramGoesOnFromThere) {
  const TableRun run = whole_run(table_top(), "G21 G61 F600\nG38.2 Z-20\nG91 G1 X5 Z1\nM2\n");
  const Position end = end_of(run);
  EXPECT_EQ(end[0], 5.0);
  EXPECT_LT(end[2], -9.0);
  EXPECT_GT(end[2], -9.3);  // 10 mm/s stop within 0.3 mm
}

TEST(ProbeCodes, TheBrakingBeginsAtTheTickBehindTheTrip) {
  const TableRun run = whole_run(table_top(), "G21 G61 F600\nG38.2 Z-20\nM2\n");
  std::size_t trip = 0;
  while (!run.states[trip].inputs.probe) {
    ++trip;
  }
  EXPECT_EQ(run.ticks[trip].v_mm_s, 10.0);
  EXPECT_EQ(run.ticks[trip + 1].v_mm_s, 10.0);  // where the braking begins
  EXPECT_LT(run.ticks[trip + 2].v_mm_s, 10.0);
}

TEST(ProbeCodes, ThePlaceIsInTheCoordinatesAndUnitsOfTheProgram) {
  const TableRun run = whole_run(table_top(),
                                 "G20 G61 F20\nG10 L2 P1 X1 Z-0.1\nG0 X1.5 Z0\nG38.2 Z-1\n"
                                 "(PRINT,#5061)\n(PRINT,#5063 #5070)\nM2\n");
  ASSERT_EQ(run.messages.size(), 2u);
  EXPECT_NEAR(std::stod(run.messages[0]), 1.5, 1e-4);  // X is where the table truly stands
  EXPECT_EQ(run.messages[1], "-0.293701 1.000000");    // -10 mm + 0.1 in
}

TEST(ProbeCodes, TheTipOfTheToolInTheSpindleTouches) {
  const TableRun run =
      whole_run(table_top(),
                "G21 G61 F600\nT1 M6\nG0 Z20\nG38.2 Z-20\n(PRINT,#5063)\nG0 Z20\nG43 H1\n"
                "G38.2 Z-20\n(PRINT,#5063)\nM2\n");
  ASSERT_EQ(run.messages.size(), 2u);
  EXPECT_EQ(run.messages[0], "2.500000");  // 12.5 mm long
  EXPECT_EQ(run.messages[1], "-10.000000");
}

TEST(ProbeCodes, InVainIsAnErrorAtTheEndOrANoughtAndTheEnd) {
  TableRun run = run_on_table(table_top(), "G21 G61 F600\nG38.2 Z-9\nG0 X9\nM2\n");
  EXPECT_EQ(run.status, TickStatus::failed);
  EXPECT_EQ(run.errors, std::vector<std::string>{"2: G38.2 met nothing"});
  EXPECT_EQ(end_of(run), (Position{0.0, 0.0, -9.0}));
  EXPECT_EQ(run.complaint, "");
  run = whole_run(table_top(), "G21 G61 F600\nG38.3 Z-9\n(PRINT,#5063 #5070)\nM2\n");
  ASSERT_EQ(run.messages.size(), 1u);
  EXPECT_EQ(run.messages[0], "-9.000000 0.000000");
}

TEST(ProbeCodes, AwayFromContactEndsWhereItIsLost) {
  const TableRun run =
      whole_run(table_top(), "G21 G61 F600\nG38.2 Z-20\nG38.4 Z5\n(PRINT,#5063 #5070)\nM2\n");
  ASSERT_EQ(run.messages.size(), 1u);
  EXPECT_EQ(run.messages[0], "-10.000000 1.000000");
  const TableRun deep = run_on_table(table_top(), "G21 G61 F600\nG1 Z-20\nG38.4 Z-15\nM2\n");
  EXPECT_EQ(deep.errors, std::vector<std::string>{"3: G38.4 ended in contact"});
  const TableRun soft =
      whole_run(table_top(), "G21 G61 F600\nG1 Z-20\nG38.5 Z-15\n(PRINT,#5070)\nM2\n");
  EXPECT_EQ(soft.messages, std::vector<std::string>{"0.000000"});
}

TEST(ProbeCodes, WhatIsSoAlreadyIsAnErrorBeforeAnythingMoves) {
  for (const char* code : {"G38.2", "G38.3"}) {
    const TableRun run =
        run_on_table(table_top(), std::string("G21 G61 F600\nG1 Z-20\n") + code + " Z-30\nM2\n");
    EXPECT_EQ(run.errors,
              std::vector<std::string>{std::string("3: ") + code + " begins in contact"});
    EXPECT_EQ(end_of(run), (Position{0.0, 0.0, -20.0}));
    EXPECT_EQ(run.complaint, "");
  }
  for (const char* code : {"G38.4", "G38.5"}) {
    const TableRun run =
        run_on_table(table_top(), std::string("G21 G61 F600\n") + code + " Z5\nM2\n");
    EXPECT_EQ(run.errors,
              std::vector<std::string>{std::string("2: ") + code + " begins without contact"});
    EXPECT_EQ(end_of(run), (Position{0.0, 0.0, 0.0}));
  }
}

TEST(ProbeCodes, AProgramBranchesOnWhatWasFound) {
  const TableRun run = whole_run(table_top(),
                                 "G21 G61 F600\n#1 = 0\no1 while [#5070 EQ 0]\n#1 = [#1 - 4]\n"
                                 "G38.3 Z#1\no1 endwhile\n(PRINT,#1 #5063)\nM2\n");
  EXPECT_EQ(run.messages, std::vector<std::string>{"-12.000000 -10.000000"});
}

TEST(ProbeCodes, AHoldOnTheWayIsHeldAndTheProbeGoesOn) {
  TableOrder order;
  order.before = [](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
    if (run.ticks.size() == 300) {
      kernel.hold();
    } else if (run.ticks.size() == 600) {
      kernel.resume();
    }
  };
  const TableRun run =
      whole_run(table_top(), "G21 G61 F600\nG38.2 Z-20\n(PRINT,#5063)\nM2\n", order);
  EXPECT_EQ(run.messages, std::vector<std::string>{"-10.000000"});
  EXPECT_EQ(run.ticks[590].v_mm_s, 0.0);
}

// At every tick of some, so that the trip comes before, in and after the hold's braking.
TEST(ProbeCodes, AHoldBesideTheTripLosesNeither) {
  const char* const text = "G21 G61 F600\nG38.2 Z-20\nG91 G1 X5\n(PRINT,#5063)\nM2\n";
  std::size_t trip = 0;
  for (const TableRun plain = whole_run(table_top(), text); !plain.states[trip].inputs.probe;) {
    ++trip;
  }
  for (std::size_t at = trip - 40; at < trip + 60; at += 3) {
    SCOPED_TRACE(at);
    TableOrder order;
    bool was_held = false;
    order.before = [&](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
      was_held = was_held || run.status == TickStatus::held;
      if (run.ticks.size() == at) {
        kernel.hold();
      } else if (run.ticks.size() == at + 300) {
        kernel.resume();
      }
    };
    const TableRun run = whole_run(table_top(), text, order);
    EXPECT_EQ(run.messages, std::vector<std::string>{"-10.000000"});
    EXPECT_TRUE(was_held);
    EXPECT_EQ(end_of(run)[0], 5.0);
  }
}

TEST(ProbeCodes, AStopOnTheWayEndsTheProgram) {
  for (const std::size_t at : {300u, 900u, 1060u, 1100u}) {
    SCOPED_TRACE(at);
    TableOrder order;
    order.before = [at](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
      if (run.ticks.size() == at) {
        kernel.stop();
      }
    };
    const TableRun run = run_on_table(table_top(), "G21 G61 F600\nG38.2 Z-20\nG1 X50\nM2\n", order);
    EXPECT_EQ(run.status, TickStatus::finished);
    EXPECT_EQ(run.complaint, "");
    EXPECT_LT(end_of(run)[0], 50.0);
  }
}

TEST(ProbeCodes, AnOverrideOnTheWayIsFollowed) {
  TableOrder order;
  order.before = [](Kernel& kernel, const TableRun& run, ProgramInputs& /*inputs*/) {
    if (run.ticks.size() == 300) {
      kernel.set_overrides({.feed = 0.5});
    }
  };
  const TableRun run =
      whole_run(table_top(), "G21 G61 F600\nG38.2 Z-20\n(PRINT,#5063)\nM2\n", order);
  EXPECT_EQ(run.messages, std::vector<std::string>{"-10.000000"});
  EXPECT_LE(run.ticks[500].v_mm_s, 5.0 + 1e-9);
  EXPECT_GT(run.ticks[500].v_mm_s, 4.99);  // the time optimum comes near its limit
}

}  // namespace
}  // namespace kerf::test
