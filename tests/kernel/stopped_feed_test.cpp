// A feed of 0 and a feed stop where the tool is at rest: what counts is what it is about to do.
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/overridden_run.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

const KernelOptions kOptimum{.profile = {.kind = ProfileKind::time_optimal}};

// With a plan ahead of the ticks.
WatchedRun run_ahead(const std::string& text, const KernelOptions& options, auto before) {
  return run_ticks({.text = text, .options = options},
                   [&](Kernel& kernel, const WatchedRun& run, Setpoint& setpoint) {
                     before(kernel, run);
                     kernel.plan();
                     return kernel.tick(setpoint);
                   });
}

WatchedRun run_at_feed_0(const std::string& text) {
  return run_ahead(text, kOptimum, [](Kernel& kernel, const WatchedRun& run) {
    if (run.next() == 0 || run.next() == 3000) {
      EXPECT_TRUE(kernel.set_overrides({.feed = run.next() == 0 ? 0.0 : 1.0}));
    }
  });
}

WatchedRun run_at_feed_stop(const std::string& text) {
  return run_ahead(text, kOptimum, [](Kernel& kernel, const WatchedRun& run) {
    if (run.next() == 0 || run.next() == 3000) {
      EXPECT_TRUE(kernel.set_feed_inputs({.stop = run.next() == 0}));
    }
  });
}

TEST(StoppedFeed, LetsNothingBegin) {
  const std::string text = "G21 G90 G61 F3000\nG1 X20\nM2\n";
  for (const WatchedRun& run : {run_at_feed_0(text), run_at_feed_stop(text)}) {
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.ticks.at(2999).s_mm, 0.0);
    EXPECT_EQ(run.statuses.at(2999), TickStatus::held);
    EXPECT_GT(run.ticks.at(3020).s_mm, 0.0);
    EXPECT_EQ(run.ticks.back().s_mm, 20.0);
  }
}

TEST(StoppedFeed, LetsBeginWhatDoesNotFollowIt) {
  for (const std::string off : {"M49", "M50 P0"}) {
    const WatchedRun run = run_at_feed_0("G21 G90 G61 F3000\n" + off + "\nG1 X20\nX0\nM2\n");
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.count(TickStatus::held), 0) << off;
    EXPECT_LT(run.ticks.size(), 3000U);
  }
  const WatchedRun run = run_at_feed_stop("G21 G90 G61 M53 P0\nG1 X20 F3000\nX0\nM2\n");
  EXPECT_EQ(run.complaint, "");
  EXPECT_EQ(run.count(TickStatus::held), 0);
}

// From a rest: not even a micrometre.
TEST(StoppedFeed, HoldsWhereWhatFollowsItBegins) {
  const std::string begin = "G21 G90 G61 F3000\n";
  for (const std::string rest : {"", "G4 P0.05\n"}) {
    for (const WatchedRun& run :
         {run_at_feed_0(begin + "M49\nG1 X20\n" + rest + "M48\nX0\nX30\nM2\n"),
          run_at_feed_stop(begin + "M53 P0\nG1 X20\n" + rest + "M53 P1\nX0\nX30\nM2\n")}) {
      EXPECT_EQ(run.complaint, "");
      EXPECT_EQ(run.ticks.at(2999).position_mm[0], 20.0);
      EXPECT_EQ(run.ticks.at(2999).s_mm, 20.0);
      EXPECT_EQ(run.statuses.at(2999), TickStatus::held);
      EXPECT_LT(run.ticks.at(3050).position_mm[0], 20.0);
      EXPECT_EQ(run.ticks.back().position_mm[0], 30.0);
    }
  }
}

TEST(StoppedFeed, LeavesAWaitAndWhatIsBehindIt) {
  const std::string begin = "G21 G90 G61 F3000\nG1 X10\nM0\n";
  for (const bool follows : {true, false}) {
    WatchedProgram program{.text = begin + (follows ? "" : "M50 P0\n") + "X20\nM2\n",
                           .options = {.waits = true}};
    const WatchedRun run =
        run_ahead(program.text, program.options, [](Kernel& kernel, const WatchedRun& watched) {
          if (watched.next() == 1000) {
            EXPECT_EQ(watched.statuses.back(), TickStatus::waiting);
            EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
          } else if (watched.next() == 1200) {
            EXPECT_EQ(watched.statuses.back(), TickStatus::waiting);
            kernel.resume();
          } else if (watched.next() == 3000) {
            EXPECT_TRUE(kernel.set_overrides({}));
          }
        });
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.ticks.back().position_mm[0], 20.0);
    EXPECT_EQ(run.ticks.size() > 3000U, follows);
    if (follows) {
      EXPECT_EQ(run.ticks.at(2000).position_mm[0], 10.0);
      EXPECT_EQ(run.ticks.at(2000).line, 3U);  // of the wait
    }
  }
}

// The hold is ahead of the tool then, and another one comes before it.
TEST(StoppedFeed, IsNoHoldOfAnOperator) {
  const std::string text = "G21 G90 G61 F3000\nM49\nG1 X60\nM48\nX0\nM2\n";
  const WatchedRun run = run_ahead(text, kOptimum, [](Kernel& kernel, const WatchedRun& watched) {
    if (watched.next() == 0) {
      EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
    } else if (watched.next() == 500) {
      kernel.hold();
    } else if (watched.next() == 1000) {
      EXPECT_EQ(watched.statuses.back(), TickStatus::held);
      EXPECT_LT(watched.ticks.back().position_mm[0], 40.0);
      kernel.resume();
    } else if (watched.next() == 3000) {
      EXPECT_EQ(watched.ticks.back().position_mm[0], 60.0);
      kernel.hold();
    } else if (watched.next() == 3100) {
      kernel.resume();
      EXPECT_TRUE(kernel.set_overrides({.feed = 0.5}));
    }
  });
  EXPECT_EQ(run.complaint, "");
  EXPECT_EQ(run.ticks.back().position_mm[0], 0.0);
  EXPECT_EQ(run.ticks.at(3099).position_mm[0], 60.0);
  EXPECT_LT(run.ticks.at(3200).position_mm[0], 60.0);
}

TEST(StoppedFeed, EndsWithAStop) {
  const std::string text = "G21 G90 G61 F3000\nM49\nG1 X20\nM48\nX0\nM2\n";
  for (const std::int64_t tick : {100, 500, 3000}) {
    const WatchedRun run = run_ahead(text, kOptimum, [&](Kernel& kernel, const WatchedRun& now) {
      if (now.next() == 0) {
        EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
      } else if (now.next() == tick) {
        kernel.stop();
      }
    });
    EXPECT_EQ(run.complaint, "") << tick;
    EXPECT_EQ(run.statuses.back(), TickStatus::finished) << tick;
    EXPECT_LE(run.ticks.back().position_mm[0], 20.0) << tick;
  }
}

// Its spindle turns, and nothing of it can be stopped once it has begun.
TEST(StoppedFeed, LetsNoTapBegin) {
  const std::string text =
      "G21 G90 G0 Z5\nS600 M3\nG98 G84 X0 Y0 Z-10 R2 F600\nG80\nG1 X50 F3000\nM5\nM2\n";
  KernelOptions options = kOptimum;
  options.start_mm = {0.0, 0.0, 5.0};
  std::int64_t stopped = 0;
  const WatchedRun run = run_ahead(text, options, [&](Kernel& kernel, const WatchedRun& now) {
    if (stopped == 0 && !now.ticks.empty() && now.ticks.back().position_mm[2] < 4.0) {
      stopped = now.next();
      EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
    } else if (stopped != 0 && now.next() == stopped + 2000) {
      EXPECT_GE(now.ticks.back().position_mm[2], 2.0);
      EXPECT_EQ(now.statuses.back(), TickStatus::held);
      EXPECT_TRUE(kernel.set_overrides({}));
    }
  });
  EXPECT_EQ(run.complaint, "");
  EXPECT_EQ(run.ticks.back().position_mm[0], 50.0);
}

// Found with a client, which had what follows here.
struct Stand {
  std::string text;
  std::int64_t asked = 0;  // before this tick the feed is stopped, and let go before tick 4000
  bool by_machine = false;
  std::vector<double> at_mm{};  // where it stands then
};

WatchedRun run_stand(const Stand& stand, KernelOptions options = {}) {
  options.waits = true;
  return run_ahead(stand.text, options, [&](Kernel& kernel, const WatchedRun& run) {
    if (run.next() == stand.asked || run.next() == 4000) {
      const bool stops = run.next() == stand.asked;
      EXPECT_TRUE(stand.by_machine ? kernel.set_feed_inputs({.stop = stops})
                                   : kernel.set_overrides({.feed = stops ? 0.0 : 1.0}));
    }
    if (run.next() > 4000 && run.statuses.back() == TickStatus::waiting) {
      kernel.resume();
    }
  });
}

// The plan is emitted as far as the wait by then.
TEST(StoppedFeed, CountsOnTheWayToAWait) {
  for (const bool by_machine : {false, true}) {
    const WatchedRun run = run_stand({.text = "G21 G90 G61 F3000\nG1 X10\nM0\nX20\nM2\n",
                                      .asked = 60,
                                      .by_machine = by_machine});
    EXPECT_EQ(run.complaint, "");
    EXPECT_EQ(run.statuses.at(3999), TickStatus::held);
    EXPECT_NEAR(run.ticks.at(3999).position_mm[0], 3.5, 0.1);  // 50 mm/s for 10 ms, and 2.25 mm
    EXPECT_EQ(run.ticks.back().position_mm[0], 20.0);
  }
}

// Also where that is emitted already, and the tool is on something that does not follow.
TEST(StoppedFeed, HoldsWhatIsPlannedToBegin) {
  const std::string begin = "G21 G90 G61 F3000\n";
  for (const Stand& stand :
       {Stand{
            .text = begin + "M49\nG1 X1\nG4 P0.2\nM48\nG1 Y2\nM2\n", .asked = 138, .at_mm = {1, 0}},
        Stand{.text = begin + "G1 X1\nM49\nG1 Y2\nM48\nG1 X3\nM2\n", .asked = 88, .at_mm = {1, 2}},
        Stand{.text = begin + "G1 X1\nM53 P0\nG1 Y2\nM53 P1\nG1 X3\nM2\n",
        .asked = 88,
        .by_machine = true,
        .at_mm = {1, 2}},
        Stand{.text = begin + "G1 X1\nG4 P0.15\nG1 Y2\nM0\nG1 X3\nM2\n",
        .asked = 138,
        .at_mm = {1, 0}}}) {
    const WatchedRun run = run_stand(stand);
    EXPECT_EQ(run.complaint, "") << stand.text;
    EXPECT_EQ(run.ticks.at(3999).position_mm[0], stand.at_mm[0]) << stand.text;
    EXPECT_EQ(run.ticks.at(3999).position_mm[1], stand.at_mm[1]) << stand.text;
    EXPECT_GT(run.ticks.size(), 4000U);
  }
}

// Whether it comes to rest before that line, or passes a rest that it would have come to anyway.
TEST(StoppedFeed, LeavesALineThatDoesNotFollowWhereverItIsAskedFor) {
  const std::string text = "G21 G90 G61 F3000\nG1 X1\nM49\nG1 Y2\nM48\nG1 X3\nM2\n";
  for (std::int64_t asked = 40; asked < 190; asked += 5) {
    const WatchedRun run = run_stand({.text = text, .asked = asked});
    EXPECT_EQ(run.complaint, "") << asked;
    EXPECT_EQ(run.ticks.at(3999).position_mm[1], 2.0) << asked;
    for (std::size_t i = 1; i < run.ticks.size(); ++i) {  // no rest within the line
      if (run.ticks[i].line == 4 && run.ticks[i].position_mm[1] > 0.0 &&
          run.ticks[i].position_mm[1] < 2.0) {
        ASSERT_GT(run.ticks[i].v_mm_s, 0.0) << asked << " " << i;
      }
    }
  }
}

// What held it counts for what is next, whatever else stops meanwhile.
TEST(StoppedFeed, LetsGoWhatNothingStopsAnyMore) {
  const std::string text = "G21 G90 G61 F3000\nM49\nG1 X1\nG1 Y2\nM2\n";
  const WatchedRun run = run_ahead(text, kOptimum, [](Kernel& kernel, const WatchedRun& now) {
    if (now.next() == 70 || now.next() == 300) {
      EXPECT_TRUE(kernel.set_feed_inputs({.stop = now.next() == 70}));
    } else if (now.next() == 200) {
      EXPECT_TRUE(kernel.set_overrides({.feed = 0.0}));
    }
  });
  EXPECT_EQ(run.complaint, "");
  EXPECT_EQ(run.ticks.at(299).position_mm[1], 0.0);
  EXPECT_LT(run.ticks.size(), 1000U);
}

}  // namespace
}  // namespace kerf::test
