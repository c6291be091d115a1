// The simulated table with faults: inputs that broken wires say, and ticks that are the table's.
#include "programs/kerf/driver/faulty_table.hpp"

#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "programs/kerf/driver/frames.hpp"
#include "tests/kernel/tick_path/trap.hpp"
#include "tests/machine/tables.hpp"

namespace kerf::program {
namespace {

using kerf::test::Trap;
using machine::DriveFault;
using machine::test::kTick;
using machine::test::real;

std::unique_ptr<machine::SimulatedTable> table() {
  return std::make_unique<machine::SimulatedTable>(real());
}

Setpoint setpoint_at(int tick) {
  return {.tick = tick, .position_mm = {0.01 * tick, -0.02 * tick, 0.0}};
}

PlannedFault fault(std::string_view kind, std::string_view axis, double at_s) {
  PlannedFault planned = planned_fault({.kind = kind, .axis = axis}).value();
  planned.at_s = at_s;
  return planned;
}

TEST(FaultyTables, WithoutAFaultHaveTheTicksOfTheTableToTheLastBit) {
  FaultyTable faulty(table(), {}, kTick);
  const auto sound = table();
  faulty.enable({});
  sound->enable({});
  for (int tick = 0; tick < 1000; ++tick) {
    faulty.write(setpoint_at(tick));
    sound->write(setpoint_at(tick));
    EXPECT_EQ(to_bytes(AnswerFrame{.tick = tick, .state = faulty.read()}),
              to_bytes(AnswerFrame{.tick = tick, .state = sound->read()}));
  }
}

TEST(FaultyTables, BreakAtTheTickOfTheirTime) {
  FaultyTable faulty(table(), {fault("drive_trip", "z", 0.05)}, kTick);
  faulty.enable({});
  for (int tick = 0; tick < 50; ++tick) {
    faulty.write(setpoint_at(tick));
    EXPECT_EQ(faulty.read().fault, DriveFault::none) << tick;
  }
  faulty.write(setpoint_at(50));
  EXPECT_EQ(faulty.read().fault, DriveFault::drive_tripped);
  EXPECT_EQ(faulty.read().fault_axis, 2);
}

TEST(FaultyTables, HaveWhatBreaksAtTheBeginBrokenBeforeTheFirstTick) {
  FaultyTable faulty(table(), {fault("probe_closed", "", 0.0), fault("door_open", "", 0.001)},
                     kTick);
  faulty.enable({});
  EXPECT_TRUE(faulty.read().inputs.probe);
  EXPECT_FALSE(faulty.read().inputs.door_open);
}

TEST(FaultyTables, BreakAtTheNextTickWhereItIsAskedFor) {
  FaultyTable faulty(table(), {}, kTick);
  faulty.enable({});
  EXPECT_TRUE(faulty.ask(fault("drive_trip", "x", 1e9)));
  EXPECT_EQ(faulty.read().fault, DriveFault::none);
  faulty.write(setpoint_at(0));
  EXPECT_EQ(faulty.read().fault, DriveFault::drive_tripped);
}

TEST(FaultyTables, Row66SwitchesStuckSayWhatTheyAreStuckAt) {
  FaultyTable faulty(table(),
                     {fault("home_switch_closed", "x", 0.0), fault("home_switch_closed", "y", 0.0),
                      fault("home_switch_open", "y", 0.0), fault("lower_limit_switch", "z", 0.0),
                      fault("upper_limit_switch", "x", 0.0), fault("emergency_loop", "", 0.0),
                      fault("probe_closed", "", 0.0), fault("spindle_stuck", "", 0.0),
                      fault("door_open", "", 0.0)},
                     kTick);
  faulty.enable({});
  Setpoint setpoint = setpoint_at(0);
  faulty.write(setpoint);
  EXPECT_TRUE(faulty.read().inputs.spindle_at_speed);  // it is to stand
  setpoint.outputs.spindle_rad_s = 10.0;
  faulty.write(setpoint);
  const machine::MachineInputs inputs = faulty.read().inputs;
  EXPECT_EQ(inputs.home, 1);
  EXPECT_EQ(inputs.lower_limit, 4);
  EXPECT_EQ(inputs.upper_limit, 1);
  EXPECT_TRUE(inputs.emergency_loop_open);
  EXPECT_TRUE(inputs.door_open);
  EXPECT_TRUE(inputs.probe);
  EXPECT_FALSE(inputs.spindle_at_speed);
}

TEST(FaultyTables, HaveAFaultOfEachName) {
  for (const std::string_view kind : kTableFaultNames) {
    EXPECT_NE(planned_fault({.kind = kind, .axis = "y"}).has_value(),
              planned_fault({.kind = kind}).has_value())
        << kind;
  }
}

TEST(FaultyTables, BreakWithoutAllocationsOrLocksInTheTick) {
  if (KERF_TRAP_WORKS == 0) {
    GTEST_SKIP() << "a sanitizer has a malloc of its own, which cannot be trapped";
  }
  std::vector<PlannedFault> planned;
  for (const std::string_view kind : kTableFaultNames) {
    const auto of_axis = planned_fault({.kind = kind, .axis = "x"});
    planned.push_back(of_axis ? *of_axis : planned_fault({.kind = kind}).value());
    planned.back().at_s = 0.05;
  }
  FaultyTable faulty(table(), planned, kTick);
  EXPECT_TRUE(faulty.ask(planned.front()));
  faulty.enable({});
  {
    const Trap trap;
    for (int tick = 0; tick < 100; ++tick) {
      faulty.write(setpoint_at(tick));
      static_cast<void>(faulty.read());
    }
  }
  EXPECT_EQ(Trap::counts().total(), 0);
  EXPECT_NE(faulty.read().fault, DriveFault::none);
}

}  // namespace
}  // namespace kerf::program
