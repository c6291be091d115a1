// A controller that jogs, with every tick against the limits.
#pragma once

#include <algorithm>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/control/limit_watch.hpp"
#include "tests/control/shop.hpp"

namespace kerf::test {

inline MachineSettings mill_with_travel() {
  MachineSettings settings = mill();
  for (AxisDrive& axis : settings.table.axes) {
    axis.travel = {.min_mm = -100.0, .max_mm = 400.0};
  }
  return settings;
}

struct JogShop : Shop {
  explicit JogShop(const MachineSettings& settings = mill_with_travel())
      : Shop(settings), watch(settings.limits) {
    give(Command::enable);
  }
  State go(int count = 1) {
    State state = State::off;
    for (int i = 0; i < count; ++i) {
      state = tick();
      watch.add(setpoint);
      fastest_mm_s = std::max(fastest_mm_s, setpoint.v_mm_s);
    }
    return state;
  }
  void go_until(State state) {
    for (int i = 0; i < kMaxTicks && go() != state; ++i) {
    }
    ASSERT_EQ(controller.status().state, state);
  }
  void jog(const Jog& jog) {
    const auto given = controller.jog(jog);
    ASSERT_TRUE(given) << given.error().reason;
  }
  ~JogShop() { EXPECT_EQ(watch.complaint(), ""); }

  LimitWatch watch;
  double fastest_mm_s = 0.0;
};

}  // namespace kerf::test
