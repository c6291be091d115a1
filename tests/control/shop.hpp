// A controller with both sides in one thread, and switches.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>
#include <kerf/controller.hpp>

#include "tests/kernel/run.hpp"

namespace kerf::test {

using State = ControllerState;

// X, Y and Z have a switch each, 5 mm beyond the lower end of the travel.
inline MachineSettings mill_with_switches() {
  MachineSettings settings = mill();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    settings.table.axes[axis].travel = {.min_mm = -100.0, .max_mm = 400.0};
    settings.manual.homing[axis] = {.switch_mm = -105.0,
                                    .home_mm = -100.0,
                                    .search_mm_s = -20.0,
                                    .latch_mm_s = 1.0,
                                    .travel_mm = 600.0,
                                    .order = axis == 2 ? 1.0 : 2.0};
  }
  settings.manual.runs_unhomed = true;
  settings.manual.unhomed_jog_mm_s = 5.0;
  return settings;
}

struct Shop {
  explicit Shop(const MachineSettings& settings = mill())
      : machine(settings), controller(settings) {}

  State tick(int count = 1) {
    State state = State::off;
    for (int i = 0; i < count; ++i) {
      controller.plan();
      state = controller.tick(setpoint);
      if (controller.has_new_place()) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          off_mm[axis] += before[axis] - setpoint.position_mm[axis];
        }
      }
      before = setpoint.position_mm;
      controller.set_home_switches(closed());
    }
    return state;
  }
  // A switch is closed where the axis truly is at it or beyond.
  [[nodiscard]] AxisSet closed() const {
    unsigned bits = always_closed;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const AxisHoming& homing = machine.manual.homing[axis];
      const double beyond_mm =
          (true_mm(axis) - homing.switch_mm) * (homing.search_mm_s > 0.0 ? 1.0 : -1.0);
      bits |= std::isfinite(homing.switch_mm) && beyond_mm >= 0.0 ? 1U << axis : 0U;
    }
    return static_cast<AxisSet>(bits & ~never_closed);
  }
  [[nodiscard]] double true_mm(std::size_t axis) const {
    return setpoint.position_mm[axis] + off_mm[axis];
  }
  void tick_until(State state) {
    for (int i = 0; i < kMaxTicks && tick() != state; ++i) {
    }
    ASSERT_EQ(controller.status().state, state);
  }
  void give(Command command) {
    const auto given = controller.give(command);
    ASSERT_TRUE(given) << name_of(command) << ": " << given.error().reason;
  }
  void start(const std::string& text) {
    give(Command::start);
    controller.feed(text);
    controller.finish();
  }
  void begin(const std::string& text) {
    give(Command::enable);
    start(text);
    tick(500);
  }
  void run_mdi(const std::string& line) {
    const auto given = controller.run_mdi(line);
    ASSERT_TRUE(given) << line << ": " << given.error().reason;
    tick_until(State::idle);
  }
  // The last message.
  [[nodiscard]] std::string told() const {
    std::array<ControllerEvent, ControllerEvent::kKept> events;
    const std::size_t count = controller.events_since(1, events);
    std::string told;
    for (std::size_t i = 0; i < count; ++i) {
      if (events[i].kind == ControllerEvent::Kind::message) {
        told = controller.message(events[i].message)->text;
      }
    }
    return told;
  }

  MachineSettings machine;
  Controller controller;
  Setpoint setpoint{};
  std::array<double, 3> off_mm{};  // of the true place from the setpoint
  Position before{};
  unsigned always_closed = 0;
  unsigned never_closed = 0;
};

struct HomingShop : Shop {
  explicit HomingShop(const MachineSettings& settings = mill_with_switches()) : Shop(settings) {
    give(Command::enable);
    tick();
  }
  void home() {
    give(Command::home);
    tick_until(State::idle);
  }
  // The search ends in a fault, and says why.
  void fails_to_home(const std::string& why) {
    give(Command::home);
    tick_until(State::fault);
    EXPECT_EQ(told(), why);
  }
};

}  // namespace kerf::test
