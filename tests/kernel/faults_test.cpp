// Faults of execution that a trusted controller knows how to meet, by their number in the list of
// faults that this project keeps: late text, a program's end, overrides, holds.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"

namespace kerf::test {
namespace {

// Judges each tick, against the path of the run without commands, too.
class Watched {
 public:
  explicit Watched(std::string text, const KernelOptions& options = {})
      : whole_(ticks_of(text, options)), kernel_(mill(), options) {
    kernel_.feed(text);
    kernel_.finish();
  }

  Kernel& kernel() { return kernel_; }
  [[nodiscard]] const WholeRun& whole() const { return whole_; }
  [[nodiscard]] const Setpoint& setpoint() const { return setpoint_; }
  TickStatus tick(std::int64_t count = 1) {
    TickStatus status = TickStatus::running;
    for (std::int64_t i = 0; i < count; ++i) {
      status = kernel_.next(setpoint_);
      checker_.add({.setpoint = setpoint_, .feedrate_mm_s = 150.0});
      off_mm_ = std::max(off_mm_, whole_.off_path_mm(setpoint_));
    }
    return status;
  }
  void tick_until(TickStatus status) {
    for (std::int64_t i = 0; i < kMaxTicks && tick() != status; ++i) {
    }
  }
  void expect_whole() {
    tick_until(TickStatus::finished);
    EXPECT_EQ(checker_.complaint(), "");
    EXPECT_LE(off_mm_, 1e-9);
    EXPECT_EQ(setpoint_.position_mm, whole_.back().position_mm);
    EXPECT_FALSE(kernel_.fault());
  }

 private:
  WholeRun whole_;
  Kernel kernel_;
  TickChecker checker_{mill().limits, true};
  Setpoint setpoint_{};
  double off_mm_ = 0.0;
};

TEST(Fault45, ALookAheadThatIsStarvedByLateTextRestsOnThePathAndGoesOn) {
  Kernel kernel(mill());
  TickChecker checker(mill().limits, true);
  Setpoint setpoint;
  const auto tick = [&] {
    const TickStatus status = kernel.next(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = 150.0});
    return status;
  };
  kernel.feed("G21 G90 G61 F6000\nG1 X40\nX80\n");
  while (tick() != TickStatus::starved) {
  }
  EXPECT_EQ(setpoint.position_mm[0], 80.0);
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  kernel.feed("X120\nM2\n");
  kernel.finish();
  while (tick() != TickStatus::finished) {
  }
  EXPECT_EQ(setpoint.position_mm[0], 120.0);
  EXPECT_EQ(checker.complaint(), "");
}

TEST(Fault46, AProgramThatEndsWithoutAStopComesToRest) {
  Kernel kernel(mill());
  kernel.feed("G21 G90 G64 P0.05 F6000\nG1 X40\nX80 Y0.5\n");
  kernel.finish();
  TickChecker checker(mill().limits, true);
  Setpoint setpoint;
  for (TickStatus status = TickStatus::running; status != TickStatus::finished;) {
    status = kernel.next(setpoint);
    checker.add({.setpoint = setpoint, .feedrate_mm_s = 150.0});
  }
  EXPECT_EQ(setpoint.position_mm, (Position{80.0, 0.5, 0.0}));
  EXPECT_EQ(setpoint.v_mm_s, 0.0);
  EXPECT_EQ(checker.complaint(), "");
}

TEST(Fault53, OverridesThatJumpEveryTenMillisecondsAndZeroInACornerKeepTheLimits) {
  Watched run("G21 G90 G64 P0.1 F4800\nG1 X30\nY30\nX0\nY0\nM2\n");
  for (int i = 0; i < 250; ++i) {
    EXPECT_TRUE(run.kernel().set_overrides({.feed = i % 2 == 0 ? 2.0 : 0.0}));
    run.tick(10);
  }
  EXPECT_TRUE(run.kernel().set_overrides({}));
  run.expect_whole();

  Watched corner("G21 G90 G64 P0.1 F4800\nG1 X30\nY30\nX0\nY0\nM2\n");
  const auto in_corner = std::ranges::find_if(
      corner.whole(), [](const Setpoint& tick) { return tick.position_mm[0] > 29.5; });
  corner.tick(in_corner->tick);
  EXPECT_TRUE(corner.kernel().set_overrides({.feed = 0.0}));
  corner.tick_until(TickStatus::held);
  EXPECT_LT(corner.setpoint().s_mm, in_corner->s_mm + 6.0);
  EXPECT_TRUE(corner.kernel().set_overrides({}));
  corner.expect_whole();
}

TEST(Fault54, AHoldAnywhereStopsOnThePathAndTheRestIsTheSamePath) {
  const auto whole = ticks_of(mixed_program());
  const auto first = [&whole](const std::function<bool(const Setpoint&)>& is) {
    return std::ranges::find_if(whole, is)->tick;
  };
  const std::int64_t corner =
      first([](const Setpoint& tick) { return tick.line == 5 && tick.v_mm_s > 0.0; });
  const std::int64_t dwell =
      first([](const Setpoint& tick) { return tick.line == 6 && tick.v_mm_s == 0.0; });
  const std::int64_t nurbs = first([](const Setpoint& tick) { return tick.line >= 12; }) + 200;
  for (const std::int64_t tick : {corner, dwell + 10, nurbs, whole.back().tick - 1}) {
    SCOPED_TRACE("tick " + std::to_string(tick));
    Watched run(mixed_program());
    run.tick(tick);
    run.kernel().hold();
    run.tick(15);
    run.kernel().hold();  // twice
    const bool ends_first = whole.back().tick - tick <= kLongestStop_ticks;
    EXPECT_EQ(run.tick(400), ends_first ? TickStatus::finished : TickStatus::held);
    run.kernel().resume();
    run.expect_whole();
  }
}

TEST(Fault56, SingleBlockInsideABlendStopsAtItsEnd) {
  Watched run("G21 G90 G64 P0.5 F4800\nG1 X30\nY30\nX0\nM2\n");
  const auto in_blend = std::ranges::find_if(run.whole(), [](const Setpoint& tick) {
    return tick.position_mm[0] > 28.0 && tick.position_mm[1] > 0.001;
  });
  run.tick(in_blend->tick);
  EXPECT_TRUE(run.kernel().set_overrides({.rapid = 0.05}));
  run.kernel().set_single_block(true);
  run.tick_until(TickStatus::waiting);
  EXPECT_EQ(run.setpoint().v_mm_s, 0.0);
  EXPECT_EQ(run.setpoint().position_mm[0], 30.0);  // after the curve, on the line along Y
  EXPECT_LT(run.setpoint().position_mm[1], 30.0);
  run.kernel().set_single_block(false);
  run.kernel().resume();
  run.expect_whole();
}

// From 150 to 30 mm/s an S-curve takes dv/A + A/J = 0.1 s, at 90 mm/s in the middle; up to 20 ms
// pass before it begins.
TEST(Fault60, AMachineThatAsksToSlowDownIsObeyedAsSoonAsTheLimitsAllow) {
  Watched run("G21 G90\nG1 X500 F9000\nM2\n");
  run.tick(1000);
  const double from_mm = run.setpoint().s_mm;
  EXPECT_TRUE(run.kernel().set_overrides({.feed = 0.2}));
  while (run.setpoint().v_mm_s > 30.5) {
    run.tick();
  }
  EXPECT_LT(run.setpoint().s_mm - from_mm, 1.1 * (0.1 * 90.0) + 0.02 * 150.0);
  run.expect_whole();
}

}  // namespace
}  // namespace kerf::test
