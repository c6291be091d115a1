// Rows 45, 46, 53 to 56 and 60 of the faults: what happens to a motion while it runs.
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>
#include <kerf/kerf.hpp>

#include "tests/kernel/shipped_text.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::faults {
namespace {

using test::expect_whole;
using test::kFastest_mm_s;
using test::kHeldTicks;
using test::mill;
using test::mixed_program;
using test::run_held;
using test::watched_run;
using test::WatchedRun;

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line + "\n");
  }
  return lines;
}

// The first tick of the whole motion at which `is_there`.
std::int64_t tick_where(const std::vector<Setpoint>& whole,
                        const std::function<bool(const Setpoint&)>& is_there) {
  const auto found = std::ranges::find_if(whole, is_there);
  EXPECT_NE(found, whole.end());
  return found - whole.begin();
}

// A line comes every 0.4 s: the tool rests on the path until it is there.
TEST(ExecutionFaults, Row45ASlowParserIsARestOnThePath) {
  constexpr std::int64_t kTicksALine = 400;
  const auto whole = test::ticks_of(mixed_program());
  const auto lines = lines_of(mixed_program());
  std::size_t fed = 0;
  const WatchedRun slow =
      watched_run({.comes_later = true}, [&](Kernel& k, const WatchedRun& so_far) {
        if (fed < lines.size() && so_far.next() % kTicksALine == 0) {
          k.feed(lines[fed++]);
          if (fed == lines.size()) {
            k.finish();
          }
        }
      });
  expect_whole(slow, whole);
  EXPECT_GT(slow.count(TickStatus::starved), 100);
  for (std::size_t i = 0; i < slow.ticks.size(); ++i) {
    ASSERT_TRUE(slow.statuses[i] != TickStatus::starved || slow.ticks[i].v_mm_s == 0.0) << i;
  }
}

// Wherever the text ends, the motion ends in a rest there.
TEST(ExecutionFaults, Row46AProgramThatJustEndsIsARestAtItsEnd) {
  const auto lines = lines_of(mixed_program());
  std::string text;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    text += lines[i];
    if (i < 2 || lines[i].starts_with("G6.2") || lines[i].starts_with("K")) {
      continue;  // nothing moves yet, or a curve that is not whole
    }
    SCOPED_TRACE(i + 1);
    const WatchedRun ended = watched_run({.text = text}, [](Kernel&, const WatchedRun&) {});
    EXPECT_EQ(ended.complaint, "");
    EXPECT_EQ(ended.ticks.back().v_mm_s, 0.0);
    const Position velocity = ended.ticks.back().velocity_mm_s;
    EXPECT_TRUE(std::ranges::all_of(velocity, [](double v) { return v == 0.0; }));
  }
}

TEST(ExecutionFaults, Row53OverrideStepsEveryTenMillisecondsKeepLimitsAndPath) {
  const auto whole = test::ticks_of(mixed_program());
  const WatchedRun stepped =
      watched_run({.text = mixed_program()}, [](Kernel& k, const WatchedRun& so_far) {
        if (so_far.next() % 10 == 0) {
          EXPECT_TRUE(k.set_overrides({.feed = so_far.next() % 20 == 0 ? 0.0 : 2.0}));
        }
      });
  expect_whole(stepped, whole);
}

TEST(ExecutionFaults, Row53AnOverrideOfZeroInACornerIsAHoldThere) {
  const std::string text = "G64 P0.2 G1 X20 F3000\nY20\nM2\n";
  const auto whole = test::ticks_of(text);
  const std::int64_t corner =
      tick_where(whole, [](const Setpoint& tick) { return tick.position_mm[1] > 0.01; });
  const WatchedRun held = watched_run({.text = text}, [&](Kernel& k, const WatchedRun& so_far) {
    if (so_far.next() == corner || so_far.next() == corner + 600) {
      EXPECT_TRUE(k.set_overrides({.feed = so_far.next() == corner ? 0.0 : 1.0}));
    }
  });
  expect_whole(held, whole);
  EXPECT_GT(held.count(TickStatus::held), 300);
}

TEST(ExecutionFaults, Row54AHoldComesToRestOnThePathWhateverTheToolIsIn) {
  const std::string corner_text = "G64 P0.2 G1 X20 F3000\nY20\nM2\n";
  const auto corner = test::ticks_of(corner_text);
  const std::int64_t in_corner =
      tick_where(corner, [](const Setpoint& tick) { return tick.position_mm[1] > 0.01; });
  for (const std::int64_t before : {12, 8, 4, 0}) {
    const WatchedRun held = run_held({.text = corner_text}, {in_corner - before});
    expect_whole(held, corner);
    EXPECT_GE(held.count(TickStatus::held), kHeldTicks);
  }
  const std::string text = mixed_program();
  const auto whole = test::ticks_of(text);
  const std::int64_t in_curve =
      tick_where(whole, [](const Setpoint& tick) { return tick.position_mm[1] > 30.0; });
  const std::int64_t in_dwell = tick_where(whole, [&](const Setpoint& tick) {
    return tick.tick > 500 && tick.v_mm_s == 0.0 && tick.limit == Constraint::rest;
  });
  const std::int64_t last = std::ssize(whole) - 1;
  for (const std::set<std::int64_t>& ticks :
       std::vector<std::set<std::int64_t>>{{in_curve},
                                           {in_curve, in_curve + 1},
                                           {in_curve, in_curve + 5, in_curve + 200},
                                           {in_dwell},
                                           {in_dwell + 10, in_dwell + 60},
                                           {last - 1},
                                           {last}}) {
    SCOPED_TRACE(*ticks.begin());
    const WatchedRun held = run_held({.text = text}, ticks);
    expect_whole(held, whole);
    EXPECT_EQ(held.count(TickStatus::held) > 0, *ticks.begin() < last - 1);
  }
}

TEST(ExecutionFaults, Row54AHoldWhereTheTextIsLateLastsUntilItIsResumed) {
  constexpr std::size_t kPeriod = 1300;
  constexpr std::size_t kHeldBefore = 390;  // it starves by then
  constexpr std::size_t kResumedBefore = 1000;
  constexpr std::size_t kRests = 150;  // after that it does
  const auto whole = test::ticks_of(mixed_program());
  const auto lines = lines_of(mixed_program());
  std::size_t fed = 0;
  const WatchedRun held =
      watched_run({.comes_later = true}, [&](Kernel& k, const WatchedRun& so_far) {
        if (fed < lines.size() && so_far.next() % 400 == 0) {
          k.feed(lines[fed++]);
          if (fed == lines.size()) {
            k.finish();
          }
        }
        const auto at = static_cast<std::size_t>(so_far.next()) % kPeriod;
        if (at == kHeldBefore) {
          k.hold();
        }
        if (at == kResumedBefore) {
          k.resume();
        }
      });
  expect_whole(held, whole);
  for (std::size_t i = 0; i + kRests < held.statuses.size(); ++i) {
    if (i % kPeriod >= kHeldBefore + kRests && i % kPeriod < kResumedBefore) {
      ASSERT_EQ(held.statuses[i], TickStatus::held) << i;
    }
  }
}

// Both sides of a controller in one thread.
ControllerState tick(Controller& controller, int count) {
  Setpoint setpoint;
  ControllerState state = ControllerState::off;
  for (int i = 0; i < count; ++i) {
    controller.plan();
    state = controller.tick(setpoint);
  }
  return state;
}

TEST(ExecutionFaults, Row55AStopEndsAHoldAndNothingResumesIt) {
  Controller controller(mill());
  ASSERT_TRUE(controller.give(Command::enable));
  ASSERT_TRUE(controller.give(Command::start));
  controller.feed("G21 G90\nG1 X1000 F6000\nM2\n");
  controller.finish();
  tick(controller, 500);
  ASSERT_TRUE(controller.give(Command::hold));
  EXPECT_EQ(tick(controller, 20), ControllerState::holding);
  ASSERT_TRUE(controller.give(Command::stop));
  const auto resumed = controller.give(Command::resume);
  ASSERT_FALSE(resumed);
  EXPECT_EQ(resumed.error().reason, "it is stopping");
  EXPECT_EQ(tick(controller, 500), ControllerState::idle);
  EXPECT_FALSE(controller.give(Command::resume));
  const double x_mm = controller.status().setpoint.position_mm[0];
  EXPECT_GT(x_mm, 0.0);
  EXPECT_LT(x_mm, 100.0);
}

TEST(ExecutionFaults, Row56SingleBlockInABlendRestsAtABlocksEnd) {
  const std::string text = "G64 P0.2 G1 X20 F3000\nY20\nX40\nM2\n";
  const auto whole = test::ticks_of(text);
  const std::int64_t in_corner =
      tick_where(whole, [](const Setpoint& tick) { return tick.position_mm[1] > 0.01; });
  std::vector<Position> rests_mm;
  const WatchedRun stepped = watched_run({.text = text}, [&](Kernel& k, const WatchedRun& so_far) {
    if (so_far.next() == in_corner - 3) {
      k.set_single_block(true);
    }
    if (!so_far.statuses.empty() && so_far.statuses.back() == TickStatus::waiting) {
      if (rests_mm.empty() || rests_mm.back() != so_far.ticks.back().position_mm) {
        rests_mm.push_back(so_far.ticks.back().position_mm);
      }
      k.resume();
    }
  });
  expect_whole(stepped, whole);
  // The blend belongs to the block before it: the junction is where the straight part of the next
  // one begins.
  ASSERT_EQ(rests_mm.size(), 3U);
  EXPECT_NEAR(rests_mm[0][0], 20.0, 1e-9);
  EXPECT_LT(rests_mm[0][1], 10.0);
  EXPECT_NEAR(rests_mm[1][1], 20.0, 1e-9);
  EXPECT_LT(rests_mm[1][0], 30.0);
  EXPECT_EQ(rests_mm[2], (Position{40.0, 20.0, 0.0}));
}

TEST(ExecutionFaults, Row56ARapidOverrideChangesRapidsAlone) {
  const WatchedRun slowed = watched_run({.text = "G61 G0 X60\nG1 X120 F3000\nM2\n"},
                                        [](Kernel& k, const WatchedRun& so_far) {
                                          if (so_far.ticks.empty()) {
                                            EXPECT_TRUE(k.set_overrides({.rapid = 0.25}));
                                          }
                                        });
  EXPECT_EQ(slowed.complaint, "");
  std::array<double, 4> fastest_mm_s{};
  for (const Setpoint& tick : slowed.ticks) {
    fastest_mm_s.at(tick.line) = std::max(fastest_mm_s.at(tick.line), tick.v_mm_s);
  }
  EXPECT_NEAR(fastest_mm_s[1], 0.25 * kFastest_mm_s, 0.05);
  EXPECT_NEAR(fastest_mm_s[2], 50.0, 0.05);
}

// The machine asks for a tenth of 100 mm/s. It is there after 10 ms more at 100 mm/s and an S-curve
// down to 10: with 5e4 mm/s^3 and 2000 mm/s^2 that takes 90/2000 + 2000/5e4 s at 55 mm/s in the
// mean.
TEST(ExecutionFaults, Row60TheMachineMaySlowDownTheMotion) {
  constexpr double kWay_mm = 100.0 * 0.011 + 55.0 * (90.0 / 2000.0 + 2000.0 / 5e4);
  double asked_at_mm = 0.0;
  double slow_at_mm = 0.0;
  const std::string text = "G61 M52 P1 G1 X200 F6000\nM2\n";
  const WatchedRun slowed = watched_run({.text = text}, [&](Kernel& k, const WatchedRun& so_far) {
    if (so_far.next() == 600) {
      asked_at_mm = so_far.ticks.back().s_mm;
      EXPECT_NEAR(so_far.ticks.back().v_mm_s, 100.0, 0.1);
      EXPECT_TRUE(k.set_feed_inputs({.adaptive = 0.1}));
    }
    if (so_far.next() > 600 && slow_at_mm == 0.0 && so_far.ticks.back().v_mm_s < 10.01) {
      slow_at_mm = so_far.ticks.back().s_mm;
    }
    if (so_far.next() == 1500) {
      EXPECT_TRUE(k.set_feed_inputs({}));
    }
  });
  expect_whole(slowed, test::ticks_of(text));
  EXPECT_GT(slow_at_mm, asked_at_mm);
  EXPECT_LE(slow_at_mm - asked_at_mm, 1.1 * kWay_mm);
}

}  // namespace
}  // namespace kerf::faults
