// A machine in another process: what it is told, and when it is given up.
#include "programs/kerf/driver/loopback_machine.hpp"

#include <algorithm>
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
