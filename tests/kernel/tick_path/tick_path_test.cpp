// The tick path allocates nothing, takes no lock, throws nothing and writes nothing.
#include <cstdio>
#include <memory>
#include <mutex>
#include <stdexcept>

#include <gtest/gtest.h>

#include "interp/interpolator.hpp"
#include "machine/simulated_table.hpp"
#include "profiles/profile.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_path/trap.hpp"

namespace kerf::test {
namespace {

using profiles::Profile;
using profiles::ProfileKind;

class TickPath : public testing::Test {
 protected:
  void SetUp() override {
    if (KERF_TRAP_WORKS == 0) {
      GTEST_SKIP() << "a sanitizer has a malloc of its own, which cannot be trapped";
    }
  }
};

TEST_F(TickPath, TrapSeesWhatItIsFor) {
  std::mutex mutex;
  {
    const Trap trap;
    int* volatile single = new int(1);
    delete single;
    void* volatile block = std::malloc(100);
    block = std::realloc(block, 200);
    std::free(block);
    block = std::aligned_alloc(64, 128);
    std::free(block);
    block = std::calloc(2, 8);
    std::free(block);
  }
  EXPECT_EQ(Trap::counts().allocations, 5);
  EXPECT_EQ(Trap::counts().frees, 4);
  {
    const Trap trap;
    mutex.lock();
    mutex.unlock();
  }
  EXPECT_EQ(Trap::counts().locks, 1);
  {
    const Trap trap;
    try {
      throw std::runtime_error("for the trap");
    } catch (const std::runtime_error&) {
    }
  }
  EXPECT_EQ(Trap::counts().throws, 1);
  {
    const Trap trap;
    std::fwrite("", 1, 0, stderr);
  }
  EXPECT_EQ(Trap::counts().writes, 1);
  { const Trap trap; }
  EXPECT_EQ(Trap::counts().total(), 0);
}

void expect_quiet_ticks(const std::string& program, const MachineSettings& settings,
                        const Profile& profile) {
  auto kernel = std::make_unique<Kernel>(settings, KernelOptions{.profile = profile});
  auto table = std::make_unique<machine::SimulatedTable>(settings.table);
  table->enable({});
  kernel->feed(program);
  kernel->finish();
  interp::Setpoint setpoint;
  machine::MachineState state;
  double chord_mm = 0.0;
  auto status = interp::TickStatus::running;
  std::int64_t ticks = 0;
  while (status == interp::TickStatus::running) {
    kernel->plan();
    {
      const Trap trap;
      status = kernel->tick(setpoint);
      table->write(setpoint);
      state = table->read();
      chord_mm = std::max(chord_mm, kernel->chord_error_mm());
    }
    ASSERT_EQ(Trap::counts().total(), 0) << "tick " << setpoint.tick << ", line " << setpoint.line;
    ++ticks;
  }
  EXPECT_EQ(status, interp::TickStatus::finished);
  EXPECT_FALSE(kernel->has_errors());
  EXPECT_GT(ticks, 1000);
  EXPECT_GT(chord_mm, 0.0);
  EXPECT_EQ(state.fault, machine::DriveFault::none);
}

TEST_F(TickPath, IsQuietUnderEveryLaw) {
  for (const ProfileKind kind :
       {ProfileKind::trapezoid, ProfileKind::s_curve, ProfileKind::sine, ProfileKind::quintic,
        ProfileKind::sine_series, ProfileKind::sigmoid, ProfileKind::time_optimal}) {
    SCOPED_TRACE(profiles::name_of(kind));
    expect_quiet_ticks(mixed_program(), mill(), Profile{kind});
  }
}

TEST_F(TickPath, IsQuietWhileStarvedAndThroughAMachineFault) {
  MachineSettings settings = mill();
  settings.table.axes[0].travel = {.min_mm = -1.0, .max_mm = 5.0};
  auto kernel = std::make_unique<Kernel>(settings);
  auto table = std::make_unique<machine::SimulatedTable>(settings.table);
  table->enable({});
  kernel->feed("G21 G90 G1 X10 F3000\nG4 P0.01\n");
  interp::Setpoint setpoint;
  machine::MachineState state;
  auto status = interp::TickStatus::running;
  for (int i = 0; i < 1000; ++i) {
    kernel->plan();
    const Trap trap;
    status = kernel->tick(setpoint);
    table->write(setpoint);
    state = table->read();
    ASSERT_EQ(Trap::counts().total(), 0) << "tick " << setpoint.tick;
  }
  EXPECT_EQ(status, interp::TickStatus::starved);
  EXPECT_EQ(state.fault, machine::DriveFault::soft_limit);
}

// A hold, a planning thread that is late, and an emergency stop, in this order.
TEST_F(TickPath, IsQuietWhateverStopsTheTool) {
  auto kernel = std::make_unique<Kernel>(mill());
  kernel->feed("G21 G90\nG1 X1000 F6000\nM2\n");
  kernel->finish();
  interp::Setpoint setpoint;
  std::array<int, 7> seen{};
  for (int i = 0; i < 3000; ++i) {
    const bool is_late = i > 1500 && i < 2300;
    if (i == 500) {
      kernel->hold();
    } else if (i == 1000) {
      kernel->resume();
    } else if (!is_late) {
      kernel->plan();
    }
    const Trap trap;
    if (i == 2800) {
      kernel->emergency_stop();
    }
    ++seen.at(static_cast<std::size_t>(kernel->tick(setpoint)));
    ASSERT_EQ(Trap::counts().total(), 0) << "tick " << i;
  }
  for (const auto status : {interp::TickStatus::held, interp::TickStatus::starved,
                            interp::TickStatus::emergency_stop}) {
    EXPECT_GT(seen.at(static_cast<std::size_t>(status)), 0) << static_cast<int>(status);
  }
}

// A thousand lines on one curve, some twenty of them in each tick.
TEST_F(TickPath, IsQuietWhereTheLineChangesWithinACurve) {
  const auto queue = std::make_unique<interp::MotionQueue>();
  interp::Interpolator interpolator(*queue, 0.001, {});
  ASSERT_TRUE(queue->push(interp::CurvePiece{
      .curve = 1, .geometry = curves::Line::between({0, 0, 0}, {5, 0, 0}).value()}));
  for (std::uint32_t i = 0; i < 1000; ++i) {
    ASSERT_TRUE(queue->push(interp::LineChange{.curve = 1, .s_mm = 0.005 * i, .line = i + 1}));
  }
  ASSERT_TRUE(queue->push(interp::Phase{.curve = 1,
                                        .s_end_mm = 5.0,
                                        .law = profiles::Transition::cruise(100.0, 5.0),
                                        .has_changes = true}));
  queue->commit();
  interp::Setpoint setpoint;
  for (int i = 0; i < 55; ++i) {
    const Trap trap;
    interpolator.next(setpoint);
    ASSERT_EQ(Trap::counts().total(), 0) << "tick " << setpoint.tick;
  }
  EXPECT_EQ(setpoint.line, 1000U);
}

TEST_F(TickPath, IsQuietOnTheButterfly) {
  MachineSettings settings;
  settings.limits.path = {
      .velocity_mm_s = 100.0, .acceleration_mm_s2 = 3000.0, .jerk_mm_s3 = 55'000.0};
  settings.limits.chord_tolerance_mm = 5e-4;
  expect_quiet_ticks(shipped_program("butterfly.ngc"), settings, Profile{ProfileKind::s_curve});
}

}  // namespace
}  // namespace kerf::test
