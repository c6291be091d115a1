#include "programs/kerf/control/plan_pace.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

PlanRecord record_of(const std::vector<std::int64_t>& looks) {
  PlanRecord record;
  for (const std::int64_t tick : looks) {
    record.add_look(tick);
  }
  return record;
}

TEST(PlanPace, NotesWhatPlanningDoesUntilItIsOver) {
  PlanPace pace(PlanRecord(), PlanPace::Does::notes);
  EXPECT_TRUE(pace.look(4));
  pace.note("hold");
  pace.note_emergency(9);
  EXPECT_FALSE(pace.begin_tick(9));
  EXPECT_FALSE(pace.next_order());
  pace.end();
  EXPECT_TRUE(pace.look(5));
  pace.note("resume");
  PlanRecord expected = record_of({4});
  expected.add_order("hold");
  expected.emergency_tick = 9;
  EXPECT_EQ(pace.record().bytes(), expected.bytes());
}

// Planning and ticks each wait for the other: what it sees is what it saw then, and at no tick it
// has done more or less.
TEST(PlanPace, OnceMoreLetsPlanningLookWhereItLooked) {
  const std::vector<std::int64_t> looks{0, 0, 3, 3, 4, 50, 50, 51, 90};
  PlanPace pace(record_of(looks), PlanPace::Does::repeats);
  std::atomic<std::int64_t> ticks = 0;
  std::atomic<std::size_t> looked = 0;
  std::vector<std::int64_t> seen;
  std::thread planning([&] {
    for (std::size_t i = 0; i < looks.size(); ++i) {
      std::int64_t tick = ticks;
      while (!pace.look(tick)) {
        tick = ticks;
      }
      seen.push_back(tick);
      ++looked;
    }
    pace.end();
  });
  while (ticks < 100) {
    pace.begin_tick(ticks);
    if (ticks < looks.back()) {
      EXPECT_EQ(looked, static_cast<std::size_t>(std::ranges::upper_bound(looks, ticks.load()) -
                                                 looks.begin()));
    }
    ++ticks;
  }
  planning.join();
  EXPECT_EQ(seen, looks);
}

TEST(PlanPace, OnceMoreGivesOrdersWhereTheyWereGiven) {
  PlanRecord record = record_of({0});
  record.add_order("hold");
  record.add_order("end");
  record.emergency_tick = 2;
  PlanPace pace(record, PlanPace::Does::repeats);
  EXPECT_FALSE(pace.next_order());
  EXPECT_TRUE(pace.look(0));
  EXPECT_FALSE(pace.next_is_end());
  EXPECT_EQ(pace.next_order(), "hold");
  EXPECT_TRUE(pace.next_is_end());
  EXPECT_FALSE(pace.next_order());
  pace.note("resume");  // nobody else is heard
  pace.end();
  EXPECT_FALSE(pace.begin_tick(1));
  EXPECT_TRUE(pace.begin_tick(2));
  EXPECT_EQ(pace.record().bytes(), record.bytes());
}

}  // namespace
}  // namespace kerf::program
