// Between which calls of a tick another thread is.
#include "interp/tick_calls.hpp"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

namespace kerf::interp {
namespace {

bool tick(TickCalls& calls) {
  return TickCalls::Call(calls).has_news();
}

TEST(TickCalls, AreCountedForWhoeverLooks) {
  TickCalls calls;
  std::vector<std::int64_t> looks;
  const auto look = [&] {
    calls.follow(
        [&](std::int64_t ticks) {
          looks.push_back(ticks);
          return true;
        },
        [] {});
  };
  look();
  tick(calls);
  tick(calls);
  look();
  EXPECT_EQ(looks, (std::vector<std::int64_t>{0, 2}));
}

TEST(TickCalls, AreLookedAtAgainWhereOneCameWhileItWasRead) {
  TickCalls calls;
  int reads = 0;
  std::int64_t seen = -1;
  calls.follow(
      [&](std::int64_t ticks) {
        seen = ticks;
        return true;
      },
      [&] {
        if (reads++ == 0) {
          tick(calls);
        }
      });
  EXPECT_EQ(reads, 2);
  EXPECT_EQ(seen, 1);
}

TEST(TickCalls, HaveNewsOnce) {
  TickCalls calls;
  EXPECT_FALSE(tick(calls));
  calls.tell([](std::int64_t ticks) { return ticks == 1; });
  EXPECT_TRUE(tick(calls));
  EXPECT_FALSE(tick(calls));
  calls.tell([](std::int64_t ticks) { return ticks == 3; });
  calls.tell([](std::int64_t ticks) { return ticks == 3; });
  EXPECT_TRUE(tick(calls));
  EXPECT_FALSE(tick(calls));
}

TEST(TickCalls, TakeALookBackWhereTheNextOneIsFasterThanTheNews) {
  TickCalls calls;
  std::vector<std::int64_t> looks;
  bool had_news = false;
  calls.tell([&](std::int64_t ticks) {
    looks.push_back(ticks);
    if (looks.size() == 1) {
      had_news = tick(calls);
    }
    return true;
  });
  EXPECT_EQ(looks, (std::vector<std::int64_t>{0, TickCalls::kTakenBack, 1}));
  EXPECT_FALSE(had_news);
  EXPECT_TRUE(tick(calls));
}

}  // namespace
}  // namespace kerf::interp
