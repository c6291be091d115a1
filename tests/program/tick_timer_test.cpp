#include "programs/kerf/run/tick_timer.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <thread>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

// Stands still but when it is slept by or moved.
class HandClock final : public TimerClock {
 public:
  [[nodiscard]] std::int64_t now_ns() const noexcept override { return now_ns_; }
  [[nodiscard]] std::int64_t with_sleep_ns() const noexcept override {
    return now_ns_ + asleep_ns_;
  }
  void sleep_until(std::int64_t due_ns) noexcept override {
    longest_sleep_ns_ = std::max(longest_sleep_ns_, due_ns - now_ns_);
    now_ns_ = std::max(now_ns_, due_ns);
  }
  void jump(std::int64_t by_ns) { now_ns_ += by_ns; }
  // The computer sleeps; CLOCK_MONOTONIC does not count that.
  void suspend(std::int64_t for_ns) { asleep_ns_ += for_ns; }
  [[nodiscard]] std::int64_t longest_sleep_ns() const { return longest_sleep_ns_; }

 private:
  std::int64_t now_ns_ = 1'000'000'000'000;
  std::int64_t asleep_ns_ = 0;
  std::int64_t longest_sleep_ns_ = 0;
};

constexpr std::int64_t kMs = 1'000'000;

class TickTimerByHand : public testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 10; ++i) {
      ASSERT_EQ(timer_.wait(), 0.0);
    }
  }
  HandClock clock_;
  TickTimer timer_{0.001, clock_};
};

TEST_F(TickTimerByHand, Row74ASleepOfTheComputerIsAGapThoughNoTickIsLate) {
  clock_.suspend(3'600'000 * kMs);
  EXPECT_NEAR(timer_.wait(), 3600.001, 1e-9);
  EXPECT_EQ(timer_.late(), 0U);
  EXPECT_EQ(timer_.wait(), 0.0);  // told once
}

TEST_F(TickTimerByHand, Row74AJumpOfTheClockIsAGap) {
  clock_.jump(400 * kMs);
  EXPECT_NEAR(timer_.wait(), 0.4, 1e-9);
  EXPECT_EQ(timer_.late(), 1U);
}

TEST_F(TickTimerByHand, Row74AClockThatJumpsBackIsAGapAndNotWaitedFor) {
  clock_.jump(-60'000 * kMs);
  EXPECT_NEAR(timer_.wait(), 60.0, 1e-9);
  EXPECT_LE(clock_.longest_sleep_ns(), kMs);
}

TEST_F(TickTimerByHand, Row74WhatADriveBearsIsNoGap) {
  clock_.suspend(240 * kMs);
  EXPECT_EQ(timer_.wait(), 0.0);
  clock_.jump(240 * kMs);
  EXPECT_EQ(timer_.wait(), 0.0);
  clock_.jump(-240 * kMs);
  EXPECT_EQ(timer_.wait(), 0.0);
}

TEST(TickTimer, TellsAGapOnceAndGoesOnFromThere) {
  TickTimer timer(0.001);
  EXPECT_EQ(timer.wait(), 0.0);    // nothing came before
  const auto late = timer.late();  // on a busy computer the first tick may be
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  EXPECT_GE(timer.wait(), 0.3);
  EXPECT_EQ(timer.late(), late + 1);
  EXPECT_GE(timer.worst_delay_s(), 0.299);
}

// Row 70: what was missed is not caught up in a burst.
TEST(TickTimer, Row70KeepsThePeriodBehindALateTick) {
  constexpr int kTicks = 8;
  TickTimer timer(0.005);
  EXPECT_EQ(timer.wait(), 0.0);
  std::this_thread::sleep_for(std::chrono::milliseconds(60));  // 12 periods
  const std::int64_t from_ns = TickTimer::now_ns();
  static_cast<void>(timer.wait());  // over at once
  EXPECT_GE(timer.delay_s(), 0.05);
  for (int i = 0; i < kTicks; ++i) {
    static_cast<void>(timer.wait());
  }
  EXPECT_GE(static_cast<double>(TickTimer::now_ns() - from_ns) * 1e-9, 0.005 * kTicks);
}

TEST(TickTimer, TakesNoPeriodForAGap) {
  TickTimer timer(0.3);
  EXPECT_EQ(timer.wait(), 0.0);
  EXPECT_EQ(timer.wait(), 0.0);
}

}  // namespace
}  // namespace kerf::program
