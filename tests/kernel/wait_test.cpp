// M0, M1, M60 and M6 wait for an answer, where the options say so.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <kerf/kernel.hpp>

#include "tests/kernel/run.hpp"
#include "tests/kernel/shipped_text.hpp"

namespace kerf::test {
namespace {

// The status of the last of so many ticks.
TickStatus run_for(Kernel& kernel, int ticks, Setpoint& setpoint) {
  TickStatus status = TickStatus::running;
  for (int i = 0; i < ticks; ++i) {
    status = kernel.next(setpoint);
  }
  return status;
}

// Answers each wait after 50 ticks; where X was at each.
std::vector<double> waits_of(const std::string& text, KernelOptions options) {
  Kernel kernel(mill(), options);
  kernel.feed(text);
  kernel.finish();
  std::vector<double> places;
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  int waited = 0;
  for (int i = 0; i < 20'000 && status != TickStatus::finished; ++i) {
    kernel.plan();
    status = kernel.tick(setpoint);
    waited = status == TickStatus::waiting ? waited + 1 : 0;
    if (waited == 1) {
      places.push_back(setpoint.position_mm[0]);
      EXPECT_EQ(setpoint.v_mm_s, 0.0);
    } else if (waited == 50) {
      kernel.resume();
    }
  }
  EXPECT_EQ(status, TickStatus::finished);
  EXPECT_EQ(setpoint.position_mm[0], 50.0);
  EXPECT_FALSE(kernel.fault());
  return places;
}

constexpr const char* kStops =
    "G21 G90 F3000\nG1 X10\nM0\nX20\nM1\nX30\nM60\nX40\nT2 M6\nX50\nM2\n";

TEST(Wait, IsForAnAnswerAtStopsAndToolChanges) {
  EXPECT_EQ(waits_of(kStops, {.waits = true}), (std::vector<double>{10.0, 30.0, 40.0}));
  EXPECT_EQ(waits_of(kStops, {.waits = true, .optional_stop = true}),
            (std::vector<double>{10.0, 20.0, 30.0, 40.0}));
}

// Found by reading: where a message was not taken, the next one kept all that follows from the
// ticks for ever.
TEST(Wait, IsLeftThoughNobodyTakesTheMessages) {
  EXPECT_EQ(
      waits_of("(MSG, a)\nG21 G90 G1 X10 F6000\nM0\nX20\n(MSG, b)\nX30\nM0\n(MSG, c)\nX50\nM2\n",
               {.waits = true, .tells_operator = true}),
      (std::vector<double>{10.0, 30.0}));
}

TEST(Wait, IsNoneWhereNobodyAnswers) {
  EXPECT_EQ(waits_of(kStops, {}), std::vector<double>{});
}

TEST(Wait, IsAnErrorOfItsLineWhereTheOptionsRefuseIt) {
  for (const bool optional_stop : {false, true}) {
    Kernel kernel(mill(), {.optional_stop = optional_stop, .refuses_waits = true});
    kernel.feed("G21 G90 F3000\nG1 X10\nM1\nX20\nT1 M6\nX30\nM2\n");
    kernel.finish();
    Setpoint setpoint;
    TickStatus status = TickStatus::running;
    while (status == TickStatus::running) {
      status = kernel.next(setpoint);
    }
    EXPECT_EQ(status, TickStatus::failed);
    EXPECT_EQ(setpoint.position_mm[0], optional_stop ? 10.0 : 20.0);
    ASSERT_FALSE(kernel.diagnostics().empty());
    EXPECT_EQ(kernel.diagnostics().back().source.line, optional_stop ? 3U : 5U);
  }
}

TEST(Wait, IsNotAnsweredBeforeTheToolIsThere) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90 G1 X10 F3000\nM0\nX20\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  for (int i = 0; i < 1000; ++i) {
    if (i == 100) {
      kernel.resume();
    }
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, TickStatus::waiting);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
}

TEST(Wait, LetsAHoldBrakeOnTheWayToIt) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90 G1 X10 F3000\nM0\nX20\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  TickStatus status = TickStatus::running;
  for (int i = 0; i < 100; ++i) {
    status = kernel.next(setpoint);
  }
  kernel.hold();
  for (int i = 0; i < 200; ++i) {
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, TickStatus::held);
  EXPECT_LT(setpoint.position_mm[0], 10.0);
  kernel.resume();
  for (int i = 0; i < 1000; ++i) {
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, TickStatus::waiting);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  kernel.resume();
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
}

// At any of the last ticks before it, where the shortest way to rest ends at the wait, and at the
// wait itself.
TEST(Wait, OutlastsAHold) {
  for (const std::string stop : {"M0", "M60", "M1", "T2 M6"}) {
    for (int tick = 160; tick < 300; tick += 3) {
      SCOPED_TRACE(stop + ", tick " + std::to_string(tick));
      Kernel kernel(mill(), {.waits = true, .optional_stop = true});
      kernel.feed("G21 G90 G1 X10 F3000\n" + stop + "\nX20\nM2\n");
      kernel.finish();
      Setpoint setpoint;
      const auto status_after = [&](int ticks) { return run_for(kernel, ticks, setpoint); };
      status_after(tick);
      kernel.hold();
      ASSERT_EQ(status_after(300), TickStatus::held);
      kernel.resume();
      ASSERT_EQ(status_after(300), TickStatus::waiting);
      ASSERT_EQ(setpoint.position_mm[0], 10.0);
      kernel.resume();
      ASSERT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
    }
  }
}

TEST(Wait, IsAnsweredAtFeed0AndMotionFollowsWithTheFeed) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90 G1 X10 F3000\nM0\nX20\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  const auto status_after = [&](int ticks) { return run_for(kernel, ticks, setpoint); };
  ASSERT_EQ(status_after(500), TickStatus::waiting);
  ASSERT_TRUE(kernel.set_overrides({.feed = 0.0}));
  kernel.resume();
  EXPECT_EQ(status_after(100), TickStatus::held);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
  ASSERT_TRUE(kernel.set_overrides({.feed = 1.0}));
  EXPECT_EQ(status_after(100), TickStatus::running);
  EXPECT_EQ(rest_of(kernel).back().position_mm[0], 20.0);
}

TEST(Wait, EndsWithAStop) {
  Kernel kernel(mill(), {.waits = true});
  kernel.feed("G21 G90 G1 X10 F3000\nM0\nX20\nM2\n");
  kernel.finish();
  Setpoint setpoint;
  for (int i = 0; i < 1000; ++i) {
    kernel.next(setpoint);
  }
  kernel.stop();
  TickStatus status = TickStatus::waiting;
  for (int i = 0; i < 20 && status != TickStatus::finished; ++i) {
    status = kernel.next(setpoint);
  }
  EXPECT_EQ(status, TickStatus::finished);
  EXPECT_EQ(setpoint.position_mm[0], 10.0);
}

}  // namespace
}  // namespace kerf::test
