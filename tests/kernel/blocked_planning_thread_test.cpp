// A planning thread that is suspended wherever it is: the tool comes to rest on the path, and the
// program ends once the thread is let go.
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <pthread.h>
#include <random>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/tick_checker.hpp"
#include "tests/kernel/watched_run.hpp"

namespace kerf::test {
namespace {

constexpr std::int64_t kBlocked = 900;  // ticks: the horizon, the way to rest and a rest after it

// A signal's handler runs in the planning thread and blocks it.
std::atomic<bool> blocks_planning = false;
std::atomic<bool> is_blocked = false;

void block_thread(int /*signal*/) {
  is_blocked = true;
  while (blocks_planning) {
  }
  is_blocked = false;
}

enum class OperatorAct : std::uint8_t { none, changes_the_feed };

class PlanningThread {
 public:
  PlanningThread(Kernel& kernel, OperatorAct by)
      : thread_([this, &kernel, by] {
          constexpr std::int64_t kPlansOfAFeed = 7;
          while (!over_) {
            if (by == OperatorAct::changes_the_feed && plans_ % kPlansOfAFeed == 0) {
              kernel.set_overrides({.feed = 0.4 + 0.1 * static_cast<double>(plans_ % 13)});
            }
            kernel.plan();
            ++plans_;
          }
        }) {}
  ~PlanningThread() {
    over_ = true;
    thread_.join();
  }
  PlanningThread(const PlanningThread&) = delete;
  PlanningThread& operator=(const PlanningThread&) = delete;

  void block() {
    blocks_planning = true;
    pthread_kill(thread_.native_handle(), SIGUSR1);
    while (!is_blocked) {
      std::this_thread::yield();
    }
  }
  static void release() { blocks_planning = false; }
  // Waits for so many more calls.
  void plan(std::int64_t calls) {
    for (const std::int64_t until = plans_ + calls; plans_ < until;) {
      std::this_thread::yield();
    }
  }

 private:
  std::atomic<bool> over_ = false;
  std::atomic<std::int64_t> plans_ = 0;
  std::thread thread_;
};

// KERF_BLOCKED_RUNS of each kind, in place of the few that a test has time for.
int runs_or(int few) {
  const char* const text = std::getenv("KERF_BLOCKED_RUNS");
  return text != nullptr ? std::atoi(text) : few;
}

void expect_rests_where_blocked(int runs, OperatorAct by) {
  struct sigaction action {};
  action.sa_handler = block_thread;
  ASSERT_EQ(sigaction(SIGUSR1, &action, nullptr), 0);
  const auto whole = ticks_of(mixed_program());
  std::mt19937 random(1709);
  for (int i = 0; i < runs; ++i) {
    const auto blocked_from =
        static_cast<std::int64_t>(random() % static_cast<std::uint32_t>(whole.back().tick));
    SCOPED_TRACE("seed 1709, run " + std::to_string(i) + ", tick " + std::to_string(blocked_from));
    Kernel kernel(mill());
    kernel.feed(mixed_program());
    kernel.finish();
    TickChecker checker(mill().limits, true);
    WatchedRun run;
    TickStatus status = TickStatus::running;
    PlanningThread planning(kernel, by);
    planning.plan(2);
    while (status != TickStatus::finished && status != TickStatus::failed &&
           run.ticks.size() < kMaxTicks) {
      const auto tick = static_cast<std::int64_t>(run.ticks.size());
      if (tick == blocked_from) {
        planning.block();
      } else if (tick == blocked_from + kBlocked) {
        PlanningThread::release();
      }
      if (tick < blocked_from || tick > blocked_from + kBlocked) {
        planning.plan(tick % 50 == 0 ? 1 : 0);
      }
      Setpoint setpoint;
      status = kernel.tick(setpoint);
      checker.add({.setpoint = setpoint, .feedrate_mm_s = kFastest_mm_s});
      run.ticks.push_back(setpoint);
      run.statuses.push_back(status);
    }
    PlanningThread::release();
    run.complaint = complaint_at_end(status, checker, kernel);
    expect_whole(run, whole);
    ASSERT_FALSE(testing::Test::HasFailure());
  }
}

TEST(BlockedPlanningThread, IsARestOnThePathWherever) {
  expect_rests_where_blocked(runs_or(40), OperatorAct::none);
}

// Ticks come far faster than planning, so most plans that are to take over are refused.
TEST(BlockedPlanningThread, IsARestOnThePathWhileTheFeedChanges) {
  expect_rests_where_blocked(runs_or(10), OperatorAct::changes_the_feed);
}

}  // namespace
}  // namespace kerf::test
