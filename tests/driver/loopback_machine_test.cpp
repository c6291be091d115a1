// A machine in another process, and all that can be wrong with it.
#include "programs/kerf/driver/loopback_machine.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/driver/loopback_peer.hpp"
#include "tests/driver/sample_frames.hpp"
#include "tests/kernel/tick_path/trap.hpp"
#include "tests/machine/machine_contract.hpp"

namespace kerf::program::test {

// The other end answers as soon as it is told; what it answers counts from the next call on.
class ServedLoopback final : public machine::Machine {
 public:
  void enable(const machine::AxisPlaces& places) noexcept override {
    pair_.machine().enable(places);
    pair_.peer.serve();
  }
  void disable() noexcept override {
    pair_.machine().disable();
    pair_.peer.serve();
  }
  void write(const Setpoint& setpoint) noexcept override {
    pair_.machine().write(setpoint);
    pair_.peer.serve();
  }
  [[nodiscard]] machine::MachineState read() const noexcept override {
    return (*pair_.opened)->read();
  }

 private:
  LoopbackPair pair_;
};

}  // namespace kerf::program::test

namespace kerf::machine::test {
INSTANTIATE_TEST_SUITE_P(Machines, MachineContract,
                         testing::Values(NamedMaker{
                             "Loopback",
                             [] { return std::make_unique<program::test::ServedLoopback>(); }}),
                         [](const auto& tested) { return std::string(tested.param.name); });
}  // namespace kerf::machine::test

namespace kerf::program::test {
namespace {

using machine::AxisState;
using machine::DriveFault;

Setpoint setpoint_at(std::int64_t tick) {
  return {.tick = tick, .position_mm = {0.01 * static_cast<double>(tick), 0.0, 0.0}};
}

class Loopback : public testing::Test {
 protected:
  static constexpr int kTimeoutTicks = 10;

  void SetUp() override {
    ASSERT_TRUE(pair_.opened) << pair_.opened.error();
    pair_.machine().enable({});
  }
  void write() { pair_.machine().write(setpoint_at(++tick_)); }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) {
      write();
      pair_.peer.serve();
    }
  }
  // Ticks without an answer until it faults.
  int ticks_to_fault() {
    int ticks = 0;
    for (; state().fault == DriveFault::none && ticks < 10'000; ++ticks) {
      write();
    }
    return ticks;
  }
  [[nodiscard]] machine::MachineState state() { return pair_.machine().read(); }

  LoopbackPair pair_;
  std::int64_t tick_ = 0;
};

TEST_F(Loopback, IsToldEachSetpointAndKnowsTheMachineOfThePeriodBefore) {
  machine::SimulatedTable table(machine::test::real());
  table.enable({});
  pair_.peer.serve();
  for (int tick = 1; tick <= 300; ++tick) {
    write();
    EXPECT_EQ(state().actual_mm, table.read().actual_mm) << tick;
    pair_.peer.serve();
    table.write(setpoint_at(tick));
  }
  const auto& told = pair_.peer.told();
  ASSERT_EQ(told.size(), 301U);
  EXPECT_EQ(told[0].call, MachineCall::enable);
  for (std::size_t i = 1; i < told.size(); ++i) {
    EXPECT_EQ(told[i].call, MachineCall::write);
    EXPECT_EQ(told[i].setpoint.tick, static_cast<std::int64_t>(i));
  }
}

TEST_F(Loopback, Row70AMachineThatDoesNotAnswerIsAFaultWithinItsTimeOut) {
  run(50);
  EXPECT_LE(ticks_to_fault(), kTimeoutTicks + 2);
  EXPECT_EQ(state().fault, DriveFault::no_answer);
  EXPECT_EQ(state().axes[0], AxisState::on);  // it may still hear: setpoints bring it to rest
  pair_.peer.serve();
  run(50);
  EXPECT_EQ(state().axes[0], AxisState::on);
  EXPECT_EQ(state().fault, DriveFault::no_answer);  // stays
  EXPECT_NEAR(pair_.peer.table().read().actual_mm[0], 0.01 * static_cast<double>(tick_), 0.1);
}

TEST_F(Loopback, Row70AMachineThatStaysSilentIsGivenUp) {
  run(50);
  for (int i = 0; i < 2 * kTimeoutTicks + 2; ++i) {
    write();
  }
  EXPECT_EQ(state().fault, DriveFault::no_answer);
  const auto axes = state().axes;
  EXPECT_EQ(std::count(axes.begin(), axes.end(), AxisState::off), 9);
  MachineCall last = MachineCall::write;
  while (const auto told = pair_.peer.receive()) {
    last = told->call;
  }
  EXPECT_EQ(last, MachineCall::disable);  // where it wakes up, it is to be off
}

TEST_F(Loopback, ALateAnswerWithinTheTimeOutIsNoFault) {
  std::vector<ToldFrame> waiting;
  for (int i = 0; i < 500; ++i) {
    write();
    while (const auto told = pair_.peer.receive()) {
      waiting.push_back(*told);
    }
    if (waiting.size() >= static_cast<std::size_t>(kTimeoutTicks)) {
      for (const ToldFrame& told : waiting) {
        pair_.peer.answer(told);
      }
      waiting.clear();
    }
  }
  EXPECT_EQ(state().fault, DriveFault::none);
}

TEST_F(Loopback, Row70AMachineThatIsGoneIsAFaultAtTheNextTick) {
  run(50);
  pair_.peer.hang_up();
  write();
  EXPECT_EQ(state().fault, DriveFault::connection_lost);
  EXPECT_EQ(state().axes[8], AxisState::off);
  write();
  pair_.machine().enable({});
  EXPECT_EQ(state().fault, DriveFault::connection_lost);  // nobody is there to be enabled
}

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

// A counter that wraps from 4.096 mm to -4.096 mm, behind 409 ticks.
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

// The time-out of the pair is 10 periods.
TEST_F(Loopback, Row72AMachineThatReadsNothingIsToldEachTickInARowUntilItIsGivenUp) {
  pair_.peer.serve();
  for (int i = 0; i < 100; ++i) {
    write();
  }
  EXPECT_EQ(state().fault, DriveFault::no_answer);
  EXPECT_EQ(state().axes[0], AxisState::off);
  std::vector<ToldFrame> told;
  while (const auto frame = pair_.peer.receive()) {
    told.push_back(*frame);
  }
  ASSERT_GT(told.size(), 20U);
  EXPECT_LE(told.size(), 23U);
  EXPECT_EQ(told.back().call, MachineCall::disable);
  for (std::size_t i = 1; i + 1 < told.size(); ++i) {
    EXPECT_EQ(told[i].call, MachineCall::write);
    EXPECT_EQ(told[i].setpoint.tick, told[i - 1].setpoint.tick + 1);
  }
}

TEST_F(Loopback, Row69AFaultOfTheOtherEndIsTheMachines) {
  run(200);
  pair_.peer.table().fail_encoder(2, machine::EncoderFailure::not_finite);
  run(2);
  EXPECT_EQ(state().fault, DriveFault::not_finite);
  EXPECT_EQ(state().fault_axis, 2);
  EXPECT_EQ(state().axes[0], AxisState::stopping);
  run(200);
  EXPECT_EQ(state().axes[0], AxisState::off);
}

TEST_F(Loopback, IsToldToBeOffBehindAFaultOfItsOwn) {
  run(5);
  machine::MachineState answer = state();
  answer.fault = DriveFault::drive_tripped;
  answer.axes.fill(AxisState::off);
  write();
  const auto told = pair_.peer.receive();
  ASSERT_TRUE(told);
  pair_.peer.answer_with(told->setpoint.tick, answer);
  write();
  EXPECT_EQ(state().fault, DriveFault::drive_tripped);
  ASSERT_TRUE(pair_.peer.receive());
  pair_.machine().disable();
  const auto last = pair_.peer.receive();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->call, MachineCall::disable);
  pair_.machine().disable();
  EXPECT_FALSE(pair_.peer.receive());
}

TEST(LoopbackMachines, LetTheOtherEndHearAllThatItWasToldBehindAnswersThatNobodyReads) {
  LoopbackPair pair;
  pair.machine().enable({});
  pair.machine().write(setpoint_at(0));
  pair.peer.answer(*pair.peer.receive());
  pair.machine().disable();
  pair.opened->reset();
  std::vector<MachineCall> heard;
  while (const auto told = pair.peer.receive()) {
    heard.push_back(told->call);
  }
  EXPECT_EQ(heard, (std::vector{MachineCall::write, MachineCall::disable}));
}

TEST(LoopbackMachines, AreRefusedBeforeAnythingMoves) {
  const auto error_of = [](const LoopbackPair::Greeting& greets) {
    LoopbackPair pair(greets);
    return pair.opened ? std::string("none") : pair.opened.error().substr(pair.path.size());
  };
  std::string other = LoopbackPeer::text_of(to_bytes(sample_answer()));
  other[4] = 2;
  EXPECT_EQ(error_of([&](LoopbackPeer& peer, const ToldFrame&) { peer.send(other); }),
            ": the machine answers 384 bytes that are no answer of version 1");
  EXPECT_EQ(error_of([](LoopbackPeer& peer, const ToldFrame&) { peer.hang_up(); }),
            ": the machine hangs up");
  EXPECT_EQ(error_of([](LoopbackPeer&, const ToldFrame&) {}),
            ": the machine does not answer within 1 s");
  const TableSettings table = machine::test::real();
  EXPECT_EQ(LoopbackMachine::open({.socket = "/nowhere/at.all", .table = table}).error(),
            "/nowhere/at.all: No such file or directory");
  EXPECT_EQ(
      LoopbackMachine::open({.socket = std::string(200, 'x'), .table = table}).error().substr(200),
      ": File name too long");
  EXPECT_EQ(LoopbackMachine::open({.socket = "x", .timeout_s = 0.3, .table = table}).error(),
            "a time-out of 0.3 s is more than 200 periods of 0.001 s");
}

TEST_F(Loopback, AllocatesLocksAndWaitsForNothingInATick) {
  if (KERF_TRAP_WORKS == 0) {
    GTEST_SKIP() << "a sanitizer has a malloc of its own, which cannot be trapped";
  }
  for (int i = 0; i < 1000; ++i) {
    {
      const kerf::test::Trap trap;
      write();
    }
    EXPECT_EQ(kerf::test::Trap::counts().total(), 0);
    if (i < 500) {
      pair_.peer.serve();
    }
  }
  EXPECT_EQ(state().fault, DriveFault::no_answer);
}

// Found by reading: before the first answer a home switch that an axis stands on was taken for
// open, and the search for another one ended as the answer came.
TEST(LoopbackInputs, AreThoseOfTheGreetingUntilAnAnswerComes) {
  LoopbackPair pair([](LoopbackPeer& peer, const ToldFrame& told) {
    machine::MachineState state = peer.table().read();
    state.inputs.home = 2U;
    peer.answer_with(told.setpoint.tick, state);
  });
  ASSERT_TRUE(pair.opened) << pair.opened.error();
  EXPECT_EQ(pair.machine().read().inputs.home, 2U);
  pair.machine().enable({});
  EXPECT_EQ(pair.machine().read().inputs.home, 2U);
  EXPECT_EQ(pair.machine().read().axes[0], AxisState::on);
}

}  // namespace
}  // namespace kerf::program::test
