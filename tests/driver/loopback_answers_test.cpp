// What a machine in another process answers, and all that can be wrong with it.
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/driver/loopback_peer.hpp"

namespace kerf::program::test {
namespace {

using machine::AxisState;
using machine::DriveFault;

// Row 71: what is no answer is a fault, and never gets into the state.
TEST_F(Loopback, Row71GarbageIsAFaultAtTheNextTick) {
  const std::string good = LoopbackPeer::text_of(to_bytes(AnswerFrame{.tick = 51, .state = {}}));
  std::string version = good;
  version[4] = 2;
  std::string other_tick = LoopbackPeer::text_of(to_bytes(AnswerFrame{.tick = 999, .state = {}}));
  std::string bits = good;
  bits[100] = static_cast<char>(bits[100] ^ 1);
  for (const std::string& bad : {std::string("garbage"), good.substr(0, 359), good + "x",
                                 std::string(100'000, 'x'), version, other_tick, bits}) {
    LoopbackPair pair;
    ASSERT_TRUE(pair.opened);
    pair.machine().enable({});
    for (std::int64_t tick = 1; tick <= 50; ++tick) {
      pair.machine().write(setpoint_at(tick));
      pair.peer.serve();
    }
    pair.machine().write(setpoint_at(51));
    EXPECT_EQ(pair.machine().read().fault, DriveFault::none);
    const auto before = pair.machine().read().actual_mm;
    pair.peer.send(bad);
    pair.machine().write(setpoint_at(52));
    EXPECT_EQ(pair.machine().read().fault, DriveFault::bad_answer) << bad.size();
    EXPECT_EQ(pair.machine().read().actual_mm, before);
    EXPECT_EQ(pair.machine().read().axes[0], AxisState::on);
  }
}

TEST_F(Loopback, Row68AReadingThatIsNotANumberNeverGetsThrough) {
  run(10);
  write();
  machine::MachineState answer = pair_.peer.table().read();
  answer.actual_mm[1] = std::numeric_limits<double>::quiet_NaN();
  pair_.peer.answer_with(tick_, answer);
  write();
  EXPECT_EQ(state().fault, DriveFault::not_finite);
  EXPECT_EQ(state().fault_axis, 1);
  EXPECT_EQ(state().actual_mm[1], 0.0);
  run(3);
  EXPECT_EQ(pair_.peer.told().back().call, MachineCall::write);
  EXPECT_NE(pair_.peer.table().read().axes[0], AxisState::on);  // told to be off
}

// Found with a machine that stopped and said no more than that: the run went on to its end.
TEST_F(Loopback, Row70AnAxisThatIsOffWithoutAFaultIsOne) {
  for (const AxisState axis_state : {AxisState::off, AxisState::stopping}) {
    LoopbackPair pair;
    pair.machine().enable({});
    pair.peer.serve();
    pair.machine().write(setpoint_at(1));
    pair.peer.serve();
    pair.machine().write(setpoint_at(2));
    EXPECT_EQ(pair.machine().read().fault, DriveFault::none);
    machine::MachineState answer = pair.peer.table().read();
    answer.axes.fill(axis_state);
    pair.peer.answer_with(2, answer);
    pair.machine().write(setpoint_at(3));
    EXPECT_EQ(pair.machine().read().fault, DriveFault::drive_tripped);
    EXPECT_EQ(pair.machine().read().fault_axis, 0);
  }
}

// Found with a machine whose latch was broken: the program went on with the number nan.
TEST_F(Loopback, Row71AFigureThatIsNotANumberNeverGetsThrough) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto fault_of = [](const std::function<void(machine::MachineState&)>& spoil) {
    LoopbackPair pair;
    pair.machine().enable({});
    pair.peer.serve();
    pair.machine().write(setpoint_at(1));
    machine::MachineState answer = pair.peer.table().read();
    spoil(answer);
    pair.peer.answer_with(1, answer);
    pair.machine().write(setpoint_at(2));
    return pair.machine().read().fault;
  };
  EXPECT_EQ(fault_of([](machine::MachineState& state) {
              state.has_latched = true;
              state.latched_mm[2] = kNan;
            }),
            DriveFault::bad_answer);
  EXPECT_EQ(fault_of([](machine::MachineState& state) { state.outputs.spindle_rad_s = kNan; }),
            DriveFault::bad_answer);
  EXPECT_EQ(fault_of([](machine::MachineState& state) { state.outputs.analog[3] = kNan; }),
            DriveFault::bad_answer);
  EXPECT_EQ(fault_of([](machine::MachineState& state) { state.latched_mm[2] = kNan; }),
            DriveFault::none)
      << "there is no latch";
}

// 5 mm is the largest following error of the table; an axis goes 0.01 mm a tick.
TEST_F(Loopback, Row63APlaceFarFromItsSetpointIsAFaultWhateverTheMachineSays) {
  for (const double said_mm : {0.0, 50.0}) {
    LoopbackPair pair;
    pair.machine().enable({});
    pair.peer.serve();
    for (std::int64_t tick = 1; tick <= 50; ++tick) {
      pair.machine().write(setpoint_at(tick));
      const auto told = pair.peer.receive();
      ASSERT_TRUE(told);
      AnswerFrame answer{.tick = tick};
      answer.state.axes.fill(AxisState::on);
      answer.state.actual_mm = told->setpoint.position_mm;
      answer.state.actual_mm[1] += tick == 50 ? 5.1 : 4.9;
      answer.state.following_error_mm[1] = said_mm;
      EXPECT_EQ(pair.machine().read().fault, DriveFault::none) << tick;
      pair.peer.answer_with(tick, answer.state);
    }
    pair.machine().write(setpoint_at(51));
    EXPECT_EQ(pair.machine().read().fault, DriveFault::following_error);
    EXPECT_EQ(pair.machine().read().fault_axis, 1);
    EXPECT_EQ(pair.machine().read().axes[0], AxisState::stopping);
    const auto told = pair.peer.receive();
    ASSERT_TRUE(told);
    EXPECT_EQ(told->call, MachineCall::disable);
  }
}

TEST_F(Loopback, Row68AReadingThatIsFrozenIsAFaultOnceTheAxisShouldBeElsewhere) {
  pair_.peer.serve();
  for (; state().fault == DriveFault::none && tick_ < 2000;) {
    write();
    while (const auto told = pair_.peer.receive()) {
      AnswerFrame answer{.tick = told->setpoint.tick};
      answer.state.axes.fill(AxisState::on);
      pair_.peer.answer_with(told->setpoint.tick, answer.state);
    }
  }
  EXPECT_EQ(state().fault, DriveFault::following_error);
  EXPECT_EQ(state().fault_axis, 0);
  EXPECT_NEAR(static_cast<double>(tick_), 500.0, 3.0);
}

// A counter that wraps from 4.096 mm to -4.096 mm, after 409 ticks.
TEST_F(Loopback, Row68AReadingThatWrapsIsAFaultAtItsTick) {
  pair_.peer.serve();
  bool is_told_to_be_off = false;
  for (; state().fault == DriveFault::none && tick_ < 2000;) {
    write();
    while (const auto told = pair_.peer.receive()) {
      is_told_to_be_off = is_told_to_be_off || told->call == MachineCall::disable;
      AnswerFrame answer{.tick = told->setpoint.tick};
      answer.state.axes.fill(AxisState::on);
      const double x_mm = told->setpoint.position_mm[0];
      answer.state.actual_mm[0] = x_mm < 4.096 ? x_mm : x_mm - 8.192;
      pair_.peer.answer_with(told->setpoint.tick, answer.state);
    }
  }
  EXPECT_EQ(state().fault, DriveFault::following_error);
  EXPECT_EQ(state().fault_axis, 0);
  EXPECT_NEAR(static_cast<double>(tick_), 411.0, 1.0);
  EXPECT_TRUE(is_told_to_be_off);
}

}  // namespace
}  // namespace kerf::program::test
