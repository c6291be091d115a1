// How soon a feed hold brings the tool to rest, and over what way.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "profiles/profile.hpp"
#include "tests/kernel/planned_path.hpp"
#include "tests/kernel/random_program.hpp"
#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/tick_checker.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

// From v, jerk J to the acceleration A, that acceleration, and jerk J to rest: v^2 / 2A + v A / 2J.
TEST(HoldSoon, OnALineBrakesInTheShortestWay) {
  const WatchedProgram program{.text = "G21 G90\nG1 X1000 F6000\nM2\n"};
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    WatchedProgram of_kind = program;
    of_kind.options.profile.kind = kind;
    const auto whole = ticks_of(of_kind.text, of_kind.options);
    const WatchedRun run = run_held(of_kind, {1000});
    std::size_t changed = 1000;
    while (run.ticks[changed].position_mm == whole[changed].position_mm) {
      ++changed;
    }
    EXPECT_LE(changed - 1000, 12U);
    constexpr double kWay_mm = 100.0 * 100.0 / 4000.0 + 100.0 * 2000.0 / 1e5;
    EXPECT_NEAR(run.first_held().s_mm - run.ticks[1009].s_mm, kWay_mm, 0.1 + 1e-6);
    EXPECT_EQ(run.complaint, "");
  }
}

// The corner in front of the arc is passed at rest, so nothing of it is left in the ticks after
// it.
TEST(HoldSoon, ComesSoonWhereTheToolHasJustLeftARest) {
  const std::string text = "G21 G90 G61 F1800\nG1 X0.1\nG18 G3 X10.1 I5\nM2\n";
  for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
    const WatchedProgram program{.text = text, .options = {.profile = {.kind = kind}}};
    for (std::int64_t tick = 0; tick < 100; ++tick) {
      SCOPED_TRACE(std::string(name_of(kind)) + ", tick " + std::to_string(tick));
      const WatchedRun run = run_held(program, {tick});
      EXPECT_EQ(run.complaint, "");
      EXPECT_LE(run.first_held().tick - tick, kLongestStop_ticks);
    }
  }
}

// Twice what a line takes with all of its limits: on curves an axis may have half of them left.
TEST(HoldSoon, ComesSoonOnRandomPrograms) {
  constexpr std::int64_t kLatest_ticks = 2 * kLongestStop_ticks;
  int holds = 0;
  for (std::uint64_t seed = 500; seed < 560; ++seed) {
    const RandomProgram program =
        random_program(seed, {.blocks = 8, .longest_mm = seed % 3 == 0 ? 5.0 : 60.0});
    for (const ProfileKind kind : {ProfileKind::s_curve, ProfileKind::time_optimal}) {
      for (std::int64_t tick = static_cast<std::int64_t>(seed % 7); tick < 900; tick += 211) {
        SCOPED_TRACE(std::string(name_of(kind)) + ", seed " + std::to_string(seed) + ", tick " +
                     std::to_string(tick));
        Kernel kernel(mill(), {.profile = {.kind = kind}, .start_mm = program.start_mm});
        kernel.feed(program.text);
        kernel.finish();
        Setpoint setpoint;
        TickStatus status = TickStatus::running;
        std::int64_t ticks = 0;
        for (; status == TickStatus::running && ticks <= tick + kLatest_ticks; ++ticks) {
          if (ticks == tick) {
            kernel.hold();
          }
          status = kernel.next(setpoint);
        }
        EXPECT_NE(status, TickStatus::running);
        holds += status == TickStatus::held ? 1 : 0;
      }
    }
  }
  EXPECT_GT(holds, 300);
}

// 5,000 lines of 0.02 mm: the way to rest goes over 700 of them.
TEST(HoldSoon, OnLinesOfLessThanATickBrakesAsOnTheLineThatTheyMake) {
  WatchedProgram program{.text = "G21 G90 G61 F12000\nG1 X20\n"};
  for (int i = 1; i <= 5000; ++i) {
    program.text += "X" + std::to_string(20.0 + 0.02 * i) + "\n";
  }
  program.text += "M2\n";
  const auto whole = ticks_of(program.text);
  for (const std::int64_t tick : {150, 300, 450}) {
    const WatchedRun run = run_held(program, {tick});
    expect_whole(run, whole);
    constexpr double kWay_mm = 200.0 * 200.0 / 4000.0 + 200.0 * 2000.0 / 1e5;
    constexpr double kMost_mm = 200.0 * 0.02;  // until it begins
    EXPECT_LT(run.first_held().s_mm - run.ticks[static_cast<std::size_t>(tick)].s_mm,
              1.06 * kWay_mm + kMost_mm);
    EXPECT_LT(run.ticks.back().tick, whole.back().tick + 400);
  }
}

Kernel time_optimal(const std::string& text) {
  Kernel kernel(default_machine(), {.profile = {.kind = ProfileKind::time_optimal}});
  kernel.feed(text);
  kernel.finish();
  return kernel;
}

struct ShortestStop {
  std::size_t tick;  // the hold's
  double way_mm;     // from the first tick that brakes
};

void expect_hardly_more(const std::string& text, const std::vector<ShortestStop>& stops) {
  Kernel free = time_optimal(text);
  const std::vector<Setpoint> whole = rest_of(free);
  for (const ShortestStop& stop : stops) {
    SCOPED_TRACE(stop.tick);
    Kernel kernel = time_optimal(text);
    Setpoint setpoint;
    std::optional<double> begin_mm;
    TickStatus status = TickStatus::running;
    for (std::size_t tick = 0; status == TickStatus::running && tick < whole.size(); ++tick) {
      if (tick == stop.tick) {
        kernel.hold();
      }
      status = kernel.next(setpoint);
      if (!begin_mm && setpoint.position_mm != whole[tick].position_mm) {
        begin_mm = setpoint.s_mm;
      }
    }
    EXPECT_EQ(status, TickStatus::held);
    ASSERT_TRUE(begin_mm);
    EXPECT_LE(setpoint.s_mm - *begin_mm, 1.04 * stop.way_mm);
  }
}

// The shortest ways are those of bench/optima/shortest_stops: linear programs around a motion.
TEST(HoldSoon, OnACurveBrakesInHardlyMoreThanTheShortestWay) {
  expect_hardly_more(shipped_program("butterfly.ngc"), {{2116, 1.1382}, {3414, 3.6524}});
}

// Joints of lines and arcs, under G64: what the motion bears changes within a cell.
TEST(HoldSoon, InARoundedPocketBrakesInHardlyMoreThanTheShortestWay) {
  expect_hardly_more(R"(G21 G90 G64 P0.01 F6000
G1 X8
Y2
G3 X5 Y5 I-3 J0
G1 X-5
G3 X-8 Y2 I0 J-3
G1 Y-2
G3 X-5 Y-5 I3 J0
G1 X5
G3 X8 Y-2 I0 J3
G1 Y0
X10.5
Y4.5
G3 X7.5 Y7.5 I-3 J0
G1 X-7.5
G3 X-10.5 Y4.5 I0 J-3
G1 Y-4.5
G3 X-7.5 Y-7.5 I3 J0
G1 X7.5
G3 X10.5 Y-4.5 I0 J3
G1 Y0
M2
)",
                     {{265, 4.9882}, {618, 4.2933}, {1175, 4.7732}});
}

// On the butterfly an axis rides on its limit of jerk there. The first other setpoint comes within
// 20 ms.
TEST(HoldSoon, BrakesSoonWhereAnAxisNeedsAllOfItsJerk) {
  Kernel free = time_optimal(shipped_program("butterfly.ngc"));
  const std::vector<Setpoint> whole = rest_of(free);
  const PlannedPath path(default_machine(), {.profile = {.kind = ProfileKind::time_optimal}},
                         shipped_program("butterfly.ngc"));
  for (const std::size_t hold : {465U, 476U, 487U, 1609U, 2610U, 3072U, 3523U, 4073U}) {
    SCOPED_TRACE(hold);
    Kernel kernel = time_optimal(shipped_program("butterfly.ngc"));
    TickChecker checker(default_machine().limits, true);
    const double feedrate_mm_s = default_machine().limits.path.velocity_mm_s;
    Setpoint setpoint;
    std::optional<std::int64_t> other;
    TickStatus status = TickStatus::running;
    for (std::size_t tick = 0; status == TickStatus::running && tick < whole.size(); ++tick) {
      if (tick == hold) {
        kernel.hold();
      }
      status = kernel.next(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = feedrate_mm_s});
      if (!other && setpoint.position_mm != whole[tick].position_mm) {
        other = static_cast<std::int64_t>(tick - hold);
      }
    }
    EXPECT_EQ(status, TickStatus::held);
    EXPECT_EQ(checker.complaint(), "");
    ASSERT_TRUE(other);
    EXPECT_LE(*other, 20);
    EXPECT_LE(path.off_mm(setpoint), 1e-9);
  }
}

}  // namespace
}  // namespace kerf::test
