// A run on a machine, written down and answered once more.
#include "programs/kerf/driver/machine_record.hpp"

#include <fstream>
#include <iterator>
#include <limits>

#include <gtest/gtest.h>

#include "machine/simulated_table.hpp"
#include "programs/kerf/driver/recording_machine.hpp"
#include "tests/kernel/tick_path/trap.hpp"
#include "tests/program/temporary_folder.hpp"

namespace kerf::program {
namespace {

using kerf::test::Trap;
using machine::DriveFault;

constexpr double kPeriod_s = 0.001;

Setpoint recorded_at(int tick) {
  return {.tick = tick, .position_mm = {0.01 * tick, -0.003 * tick, 0.0}};
}

class Records : public testing::Test {
 protected:
  void record(int ticks) {
    auto writer = RecordWriter::create(path_, kPeriod_s, RecordWriter::WhenFull::wait);
    ASSERT_TRUE(writer);
    RecordingMachine machine(std::make_unique<machine::SimulatedTable>(TableSettings{}), **writer);
    machine.enable({});
    for (int tick = 0; tick < ticks; ++tick) {
      machine.write(recorded_at(tick));
      states_.push_back(machine.read());
    }
    machine.disable();
    EXPECT_EQ((*writer)->finish({}), std::nullopt);
  }
  [[nodiscard]] std::string bytes() const {
    std::ifstream file(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] tl::expected<RecordReader, std::string> read(const std::string& bytes) const {
    std::ofstream(path_, std::ios::binary | std::ios::trunc) << bytes;
    return RecordReader::open(path_, kPeriod_s);
  }

  TemporaryFolder folder_;
  std::string path_ = folder_ / "run.rec";
  std::vector<machine::MachineState> states_;
};

TEST_F(Records, AnswerARunOnceMoreBitForBit) {
  record(500);
  ReplayingMachine replay(RecordReader::open(path_, kPeriod_s).value());
  EXPECT_EQ(replay.read().fault, DriveFault::not_enabled);
  replay.enable({});
  for (int tick = 0; tick < 500; ++tick) {
    replay.write(recorded_at(tick));
    ASSERT_EQ(to_bytes(AnswerFrame{.state = replay.read()}),
              to_bytes(AnswerFrame{.state = states_[static_cast<std::size_t>(tick)]}));
  }
  EXPECT_EQ(replay.calls_left(), 1U);
  replay.disable();
  EXPECT_EQ(replay.calls_left(), 0U);
  EXPECT_EQ(replay.read().fault, DriveFault::not_enabled);
}

TEST_F(Records, FaultAtTheVeryTickThatIsAnother) {
  record(10);
  ReplayingMachine replay(RecordReader::open(path_, kPeriod_s).value());
  replay.enable({});
  replay.write(recorded_at(0));
  Setpoint other = recorded_at(1);
  other.position_mm[0] = std::nextafter(other.position_mm[0], 1.0);
  replay.write(other);
  EXPECT_EQ(replay.read().fault, DriveFault::another_run);
  EXPECT_EQ(replay.read().axes[0], machine::AxisState::off);
  replay.write(recorded_at(2));
  EXPECT_EQ(replay.read().fault, DriveFault::another_run);
}

TEST_F(Records, FaultWhereTheRunGoesOnLongerThanTheRecord) {
  record(2);
  ReplayingMachine replay(RecordReader::open(path_, kPeriod_s).value());
  replay.enable({});
  replay.write(recorded_at(0));
  replay.write(recorded_at(1));
  EXPECT_EQ(replay.read().fault, DriveFault::none);
  replay.write(recorded_at(2));
  EXPECT_EQ(replay.read().fault, DriveFault::another_run);
}

// Row 79: torn at any byte, and with any bit turned over.
TEST_F(Records, Row79AreRefusedWhereTheyAreTorn) {
  record(2);
  const std::string whole = bytes();
  ASSERT_TRUE(read(whole));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(read(whole.substr(0, size))) << size;
  }
  EXPECT_FALSE(read(whole + whole.substr(whole.size() - 1)));
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << (at % 8)));
    EXPECT_FALSE(read(damaged)) << at;
  }
}

TEST_F(Records, AreRefusedWhereTheyAreForeign) {
  record(1);
  EXPECT_EQ(RecordReader::open(path_, 0.002).error(),
            path_ + ": the record has a period of 0.001 s, this machine 0.002 s");
  EXPECT_EQ(read(std::string(1000, 'G')).error(),
            path_ + ": no record of a machine, or of another version of kerf");
  EXPECT_FALSE(RecordReader::open(path_ + ".other", kPeriod_s));
  EXPECT_FALSE(RecordReader::open(folder_.path().string(), kPeriod_s));
}

TEST_F(Records, ARunThatIsKilledLeavesNone) {
  {
    auto writer = RecordWriter::create(path_, kPeriod_s, RecordWriter::WhenFull::drop);
    ASSERT_TRUE(writer);
    (*writer)->push({});
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
  EXPECT_TRUE(std::filesystem::exists(path_ + ".incomplete"));
  EXPECT_TRUE((*RecordWriter::create(path_, kPeriod_s, RecordWriter::WhenFull::drop))
                  ->follows_incomplete());
}

// Row 72: a disk that takes nothing holds up no tick, and what is lost is counted.
TEST_F(Records, Row72AFullDiskOrASlowOneHoldsUpNoTick) {
  auto full = RecordWriter::create("/dev/full", kPeriod_s, RecordWriter::WhenFull::drop);
  ASSERT_TRUE(full);
  for (int i = 0; i < 20'000; ++i) {
    (*full)->push({});
  }
  const auto error = (*full)->finish({});
  ASSERT_TRUE(error);
  EXPECT_NE(error->find("No space left on device"), std::string::npos) << *error;

  auto slow = RecordWriter::create(path_, kPeriod_s, RecordWriter::WhenFull::drop);
  ASSERT_TRUE(slow);
  for (int i = 0; i < 200'000; ++i) {  // at once: far faster than any disk
    (*slow)->push({});
  }
  const auto lost = (*slow)->finish({});
  ASSERT_TRUE(lost);
  EXPECT_NE(lost->find("the record lacks "), std::string::npos) << *lost;
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(Records, AreWrittenAndAnsweredWithoutAllocationsLocksOrWritesInTheTick) {
  if (KERF_TRAP_WORKS == 0) {
    GTEST_SKIP() << "a sanitizer has a malloc of its own, which cannot be trapped";
  }
  auto writer = RecordWriter::create(path_, kPeriod_s, RecordWriter::WhenFull::drop);
  ASSERT_TRUE(writer);
  RecordingMachine machine(std::make_unique<machine::SimulatedTable>(TableSettings{}), **writer);
  const auto run = [](machine::Machine& driven) {
    machine::MachineState state;
    driven.enable({});
    for (int tick = 0; tick < 1000; ++tick) {
      driven.write(recorded_at(tick));
      state = driven.read();
    }
    driven.disable();
    return state.fault;
  };
  {
    const Trap trap;
    EXPECT_EQ(run(machine), DriveFault::none);
  }
  EXPECT_EQ(Trap::counts().total(), 0);
  ASSERT_EQ((*writer)->finish({}), std::nullopt);
  ReplayingMachine replay(RecordReader::open(path_, kPeriod_s).value());
  {
    const Trap trap;
    EXPECT_EQ(run(replay), DriveFault::none);
  }
  EXPECT_EQ(Trap::counts().total(), 0);
}

}  // namespace
}  // namespace kerf::program
