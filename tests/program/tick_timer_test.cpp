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

TEST(TickTimer, TakesNoPeriodForAGap) {
  TickTimer timer(0.3);
  EXPECT_EQ(timer.wait(), 0.0);
  EXPECT_EQ(timer.wait(), 0.0);
}

}  // namespace
}  // namespace kerf::program
