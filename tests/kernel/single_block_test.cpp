// Single block: a rest and a wait at the junction after each block of the program.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

struct SteppedRun {
  WatchedRun run;
  std::vector<Setpoint> waits;        // the first tick of each
  std::vector<std::uint64_t> blocks;  // TickDetail::block there
};

struct Switching {
  std::int64_t on_before = 0;  // this tick
  std::int64_t off_before = kMaxTicks;
};

// Answers each wait after some ticks.
SteppedRun run_stepped(const std::string& text, const KernelOptions& options,
                       const Switching& switching) {
  constexpr int kWaitTicks = 5;
  SteppedRun stepped;
  int waited = 0;
  stepped.run =
      watched_run({.text = text, .options = options}, [&](Kernel& kernel, const WatchedRun& run) {
        const bool waits = run.next() > 0 && run.statuses.back() == TickStatus::waiting;
        waited = waits ? waited + 1 : 0;
        if (waited == 1) {
          stepped.waits.push_back(run.ticks.back());
          stepped.blocks.push_back(kernel.detail().block);
        } else if (waited == kWaitTicks) {
          kernel.resume();
          waited = 0;
        }
        if (run.next() == switching.on_before || run.next() == switching.off_before) {
          kernel.set_single_block(run.next() == switching.on_before);
        }
      });
  return stepped;
}

std::vector<std::uint32_t> lines_of(const std::vector<Setpoint>& ticks) {
  std::vector<std::uint32_t> lines;
  for (const Setpoint& tick : ticks) {
    lines.push_back(tick.line);
  }
  return lines;
}

constexpr const char* kSquareProgram =
    "G21 G90 G61 F3000\nG1 X20\nY20\nG4 P0.1\nG3 X0 Y20 I-10\nM3 S100\nG1 Y0\nM2\n";

// Which G64 would make one curve of.
TEST(SingleBlock, WaitsAtTheEndOfEachOfManyShortLines) {
  constexpr int kLines = 100;
  std::string text = "G21 G90 G64 P0.01 Q0.01 F3000\n";
  for (int i = 1; i <= kLines; ++i) {
    text +=
        "G1 X" + std::to_string(0.5 * i) + " Y" + std::to_string(5.0 * std::sin(0.05 * i)) + "\n";
  }
  const SteppedRun stepped = run_stepped(text + "M2\n", {}, {});
  EXPECT_EQ(stepped.run.complaint, "");
  EXPECT_GE(stepped.waits.size(), kLines - 1U);
  for (std::size_t i = 0; i + 1 < stepped.waits.size(); ++i) {
    EXPECT_LT(stepped.waits[i + 1].s_mm - stepped.waits[i].s_mm, 1.0);  // two lines: 1.1
  }
}

TEST(SingleBlock, WaitsAtTheEndOfEachBlockOfTheProgram) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const SteppedRun run = run_stepped(kSquareProgram, options, {});
    expect_whole(run.run, ticks_of(kSquareProgram, options));
    EXPECT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}));
    const std::vector<Position> junctions{{20.0, 0.0, 0.0}, {20.0, 20.0, 0.0}, {20.0, 20.0, 0.0},
                                          {0.0, 20.0, 0.0}, {0.0, 20.0, 0.0},  {0.0, 0.0, 0.0}};
    ASSERT_EQ(run.waits.size(), junctions.size());
    for (std::size_t i = 0; i < junctions.size(); ++i) {
      EXPECT_EQ(run.waits[i].position_mm, junctions[i]) << i;
    }
  }
}

TEST(SingleBlock, MayBeSwitchedOnInMotionAndOffAgain) {
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(mixed_program(), options);
    int runs = 0;
    int with_waits = 0;
    for (std::int64_t tick = 1; tick < whole.back().tick; tick += 97) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick));
      ++runs;
      const SteppedRun run =
          run_stepped(mixed_program(), options, {.on_before = tick, .off_before = tick + 900});
      expect_whole(run.run, whole);
      with_waits += run.waits.empty() ? 0 : 1;
      ASSERT_FALSE(testing::Test::HasFailure());
    }
    EXPECT_GT(with_waits, runs / 2);
  }
}

// 50 mm/s come to rest in 2.25 mm; the junctions are 10 mm apart.
TEST(SingleBlock, SwitchedOnInMotionRestsAtTheNextJoint) {
  std::string text = "G21 G90 G61 F3000\n";
  for (int x = 10; x <= 200; x += 10) {
    text += "G1 X" + std::to_string(x) + "\n";
  }
  text += "M2\n";
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const KernelOptions options{.profile = {.kind = kind}};
    const auto whole = ticks_of(text, options);
    for (const std::int64_t tick : {500, 550, 600, 677}) {
      const double from_mm = whole.at(static_cast<std::size_t>(tick) + 10).s_mm;
      const SteppedRun run = run_stepped(text, options, {.on_before = tick});
      expect_whole(run.run, whole);
      ASSERT_FALSE(run.waits.empty());
      const double rest_mm = run.waits.front().position_mm[0];
      EXPECT_EQ(std::fmod(rest_mm, 10.0), 0.0);
      EXPECT_GT(rest_mm, from_mm);
      EXPECT_LT(rest_mm, from_mm + 2.25 + 10.0 + 1.0);
      EXPECT_EQ(run.waits.size(), static_cast<std::size_t>(200.0 - rest_mm) / 10 + 1);
    }
  }
}

// The tool already brakes there: a corner that is exact, one after a dwell.
TEST(SingleBlock, SwitchedOnBeforeARestWaitsThere) {
  for (const std::string rest : {"", "G4 P0.05\n"}) {
    const std::string text = "G21 G90 G61 F6000\nG1 X50\n" + rest + "G1 X0\nM2\n";
    for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
      const KernelOptions options{.profile = {.kind = kind}};
      const auto whole = ticks_of(text, options);
      const auto rests = std::ranges::find(whole, 50.0, &Setpoint::s_mm)->tick;
      for (std::int64_t before = 11; before < 150; before += 3) {
        SCOPED_TRACE(rest + std::string(name_of(kind)) + ", " + std::to_string(before));
        const SteppedRun run = run_stepped(text, options, {.on_before = rests - before});
        expect_whole(run.run, whole);
        ASSERT_FALSE(run.waits.empty());
        EXPECT_EQ(run.waits.front().position_mm[0], 50.0);
        EXPECT_EQ(run.waits.size(), rest.empty() ? 2U : 3U);
        ASSERT_FALSE(testing::Test::HasFailure());
      }
    }
  }
}

// Within 0.2 mm the corners between the lines would become curves.
TEST(SingleBlock, RestsInTheCornersThatG64WouldBlend) {
  const std::string lines = "G1 X20\nY20\nX0\nY0\nM2\n";
  const SteppedRun run = run_stepped("G21 G90 G64 P0.2 F3000\n" + lines, {}, {});
  expect_whole(run.run, ticks_of("G21 G90 G61 F3000\n" + lines));
  EXPECT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{2, 3, 4, 5}));
  const std::vector<Position> corners{{20.0, 0.0, 0.0}, {20.0, 20.0, 0.0}, {0.0, 20.0, 0.0}, {}};
  ASSERT_EQ(run.waits.size(), corners.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_EQ(run.waits[i].position_mm, corners[i]) << i;
  }
}

// Of which G64 makes one smooth curve: the jumps of its curvature are no joints of blocks.
TEST(SingleBlock, LeavesACurveOfOneBlockSmooth) {
  const std::string text =
      "G6.2 P3 K0 X0 Y0 R1 F3000\nK0 X10 Y0 R1\nK0 X20 Y10 R1\nK1 X30 Y-10 R1\nK2 X40 Y10 R1\n"
      "K3 X50 Y0 R1\nK4\nK4\nK4\nG1 X60\nM2\n";
  const SteppedRun run = run_stepped("G21 G90 G64 P0.1\n" + text, {}, {});
  const SteppedRun exact = run_stepped("G21 G90 G61\n" + text, {}, {});
  EXPECT_EQ(run.run.complaint, "");
  EXPECT_EQ(exact.run.complaint, "");
  EXPECT_EQ(run.waits.size(), exact.waits.size());
  EXPECT_LT(run.run.ticks.size(), exact.run.ticks.size());
}

// It once took the three rounds for one block, and a whole subprogram in a file, which is all of
// the line that calls it.
TEST(SingleBlock, WaitsForEachBlockWhereTheyAreOfOneLine) {
  for (const std::string again : {"G4 P0.05", "M3 S500", "M64 P1", "G1 Y5"}) {
    const SteppedRun run = run_stepped(
        "G21 G90 F3000\nG1 X10\no1 repeat [3]\n" + again + "\no1 endrepeat\nG1 X0\nM2\n", {}, {});
    EXPECT_EQ(lines_of(run.waits), again == "G1 Y5"
                                       ? (std::vector<std::uint32_t>{2, 4, 6})  // it is there
                                       : (std::vector<std::uint32_t>{2, 4, 4, 4, 6}))
        << again;
  }
  KernelOptions options;
  options.subprograms = [](std::string_view) {
    return SubprogramText{.file = "steps.ngc",
                          .text =
                              "o<steps> sub\nG1 X10 F3000\nM8\nG1 Z-5\nG4 P0.05\nM3 S500\n"
                              "G1 Y5\nS600\nG1 Y9\nM64 P1\nG1 X0\no<steps> endsub\n"};
  };
  const SteppedRun run = run_stepped("G21 G90 G61\no<steps> call\nG1 Y0\nM2\n", options, {});
  EXPECT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3}));
}

// After an output it was the block before.
TEST(SingleBlock, WaitsInTheBlockThatHasEnded) {
  const SteppedRun run =
      run_stepped("G21 G90 G61 F3000\nG1 X10\nM3 S500\nG1 X20\nM5\nG4 P0.05\nG1 X0\nM2\n", {}, {});
  ASSERT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{2, 3, 4, 5, 6, 7}));
  for (std::size_t i = 1; i < run.blocks.size(); ++i) {
    EXPECT_EQ(run.blocks[i], run.blocks[i - 1] + 1) << i;
  }
}

// A blend that was made by then stays, and is of the block that follows it.
TEST(SingleBlock, SwitchedOnInMotionRestsBehindBlendsThatAreMade) {
  const std::string text = "G21 G90 G64 P0.2 F3000\nG1 X20\nY20\nX0\nY0\nM2\n";
  const SteppedRun run = run_stepped(text, {}, {.on_before = 100});
  expect_whole(run.run, ticks_of(text));
  EXPECT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{3, 4, 5, 5}));
}

TEST(SingleBlock, LetsAProgramWaitForItsOwnStops) {
  const std::string text = "G21 G90 F3000\nG1 X10\nM0\nX20\nM2\n";
  const SteppedRun run = run_stepped(text, {.waits = true}, {});
  expect_whole(run.run, ticks_of(text));
  EXPECT_EQ(lines_of(run.waits), (std::vector<std::uint32_t>{2, 3, 4}));
}

}  // namespace
}  // namespace kerf::test
