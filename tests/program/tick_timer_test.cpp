#include "programs/kerf/run/tick_timer.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace kerf::program {
namespace {

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
