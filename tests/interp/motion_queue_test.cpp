// The word that the producer's commit and the consumer's take exchange.
#include "interp/motion_queue.hpp"

#include <atomic>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

namespace kerf::interp {
namespace {

using Ahead = MotionQueue::Ahead;

void commit_stop(MotionQueue& queue, std::int64_t tick, Ahead ahead = Ahead::written) {
  StopAhead& stop = queue.spare_stop();
  stop.from = ahead == Ahead::beside ? 1 : 0;
  stop.tick = tick;
  ASSERT_TRUE(queue.commit(ahead));
}

TEST(MotionQueue, GivesAStopAheadAtItsTickToItsPlanAlone) {
  const auto queue = std::make_unique<MotionQueue>();
  commit_stop(*queue, 7);
  EXPECT_EQ(queue->take_stop(0, 6), nullptr);
  EXPECT_EQ(queue->take_stop(1, 7), nullptr);
  ASSERT_NE(queue->take_stop(0, 7), nullptr);
  EXPECT_TRUE(queue->stop_taken());
  EXPECT_FALSE(queue->commit());
  queue->release_stop();
  EXPECT_TRUE(queue->commit());
  EXPECT_EQ(queue->take_stop(0, 7), nullptr);
}

TEST(MotionQueue, KeepsOfTwoStopsThatOfThePlanInForce) {
  for (const bool took_over : {false, true}) {
    const auto queue = std::make_unique<MotionQueue>();
    commit_stop(*queue, 7);
    commit_stop(*queue, 9, Ahead::beside);
    queue->settle(took_over);
    EXPECT_EQ(queue->take_stop(1, 9) != nullptr, took_over);
    EXPECT_EQ(queue->take_stop(0, 7) != nullptr, !took_over);
  }
}

// Commits that keep the stop ahead come between the consumer's look and its take, each with the
// phase that it is for.
TEST(MotionQueue, GivesAStopAheadAtItsTickWhateverIsCommittedMeanwhile) {
  constexpr std::int64_t kStops = 20'000;
  const auto queue = std::make_unique<MotionQueue>();
  std::atomic<std::int64_t> ahead = 0;
  std::atomic<std::int64_t> asked = 0;
  std::thread producer([&] {
    for (std::int64_t tick = 1; tick <= kStops; ++tick) {
      commit_stop(*queue, tick);
      ahead = tick;
      while (asked < tick) {
        if (queue->push(Phase{})) {
          queue->commit(Ahead::same);
        }
        std::this_thread::yield();
      }
      queue->release_stop();
    }
  });
  std::int64_t missed = 0;
  for (std::int64_t tick = 1; tick <= kStops; ++tick) {
    while (ahead < tick) {
      std::this_thread::yield();
    }
    missed += queue->take_stop(0, tick) == nullptr ? 1 : 0;
    asked = tick;
    while (queue->next_phase() != nullptr && ahead == tick) {
      queue->pop_phase();
    }
  }
  producer.join();
  EXPECT_EQ(missed, 0);
}

}  // namespace
}  // namespace kerf::interp
