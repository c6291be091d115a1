// Axes find their home switches.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/control/limit_watch.hpp"
#include "tests/control/shop.hpp"

namespace kerf::test {
namespace {

// The latch finds the switch at the setpoint of a tick: at 1 mm/s within 1 um.
TEST(Homing, GivesEachAxisItsTruePlace) {
  HomingShop shop;
  shop.off_mm = {13.7, -8.3, 41.9};
  shop.tick();
  EXPECT_EQ(shop.controller.status().unhomed, 7U);
  shop.home();
  EXPECT_EQ(shop.controller.status().unhomed, 0U);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(shop.setpoint.position_mm[axis], -100.0, 1e-9);
    EXPECT_NEAR(shop.true_mm(axis), -100.0, 1.001e-3);
  }
}

TEST(Homing, GoesInItsOrderOneAxisAtATime) {
  HomingShop shop;
  shop.give(Command::home);
  std::string order;
  Position before = shop.setpoint.position_mm;
  while (shop.tick() == State::homing) {
    int moving = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool moves =
          shop.setpoint.position_mm[axis] != before[axis] && !shop.controller.has_new_place();
      moving += moves ? 1 : 0;
      if (moves && (order.empty() || order.back() != "XYZ"[axis])) {
        order += "XYZ"[axis];
      }
    }
    ASSERT_LE(moving, 1);
    before = shop.setpoint.position_mm;
  }
  EXPECT_EQ(order, "ZXY");
}

TEST(Homing, KeepsTheLimitsAtEveryTickButWhereAPlaceIsGiven) {
  HomingShop shop;
  shop.off_mm = {3.0, 0.0, -5.0};
  shop.give(Command::home);
  LimitWatch watch(shop.machine.limits);
  for (State state = State::homing; state == State::homing;) {
    state = shop.tick();
    if (shop.controller.has_new_place()) {
      EXPECT_EQ(watch.complaint(), "");
      EXPECT_EQ(shop.setpoint.v_mm_s, 0.0);
      watch = LimitWatch(shop.machine.limits);
    }
    watch.add(shop.setpoint);
  }
  EXPECT_EQ(watch.complaint(), "");
}

// Found with a client: it was asked for before the first tick, so no switch was known to be closed.
TEST(Homing, BeginsBeforeTheFirstTickWithAnyAxisOnItsSwitch) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Shop shop(mill_with_switches());
    shop.off_mm[axis] = -107.0;
    shop.give(Command::enable);
    shop.give(Command::home);
    shop.tick_until(State::idle);
    EXPECT_EQ(shop.controller.status().unhomed, 0U) << axis;
    EXPECT_NEAR(shop.true_mm(axis), -100.0, 1.001e-3);
  }
}

TEST(Homing, BeginsOnASwitchThatIsClosed) {
  HomingShop shop;
  shop.off_mm = {-107.0, 0.0, 0.0};
  shop.tick(2);  // the second one sees it
  shop.home();
  EXPECT_NEAR(shop.true_mm(0), -100.0, 1.001e-3);
}

TEST(Homing, FindsASwitchAtTheUpperEnd) {
  MachineSettings settings = mill_with_switches();
  settings.manual.homing[2].switch_mm = 403.0;
  settings.manual.homing[2].search_mm_s = 25.0;
  settings.manual.homing[2].home_mm = 350.0;
  HomingShop shop(settings);
  shop.home();
  EXPECT_NEAR(shop.true_mm(2), 350.0, 1.001e-3);
  EXPECT_NEAR(shop.setpoint.position_mm[2], 350.0, 1e-9);
}

TEST(Homing, IsTheSameFromAnywhere) {
  for (const double off_mm : {-40.0, -0.3, 17.25, 90.0}) {
    HomingShop shop;
    shop.off_mm = {off_mm, 0.0, 0.0};
    shop.home();
    EXPECT_NEAR(shop.true_mm(0), -100.0, 1.001e-3) << off_mm;
  }
}

TEST(Homing, IsWantedBeforeAProgramUnlessTheMachineFileSaysOtherwise) {
  MachineSettings settings = mill_with_switches();
  settings.manual.runs_unhomed = false;
  HomingShop shop(settings);
  EXPECT_EQ(shop.controller.give(Command::start).error().reason,
            "the axes are not homed: home first");
  EXPECT_EQ(shop.controller.run_mdi("G0 X1").error().reason, "the axes are not homed: home first");
  shop.home();
  shop.start("G21 G90 G0 X5\nM2\n");
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.setpoint.position_mm[0], 5.0);
  HomingShop free;
  free.start("G21 G90 G0 X5\nM2\n");
  free.tick_until(State::idle);
}

TEST(Homing, IsRefusedWithoutSwitches) {
  HomingShop shop(mill());
  EXPECT_EQ(shop.controller.status().unhomed, 0U);
  EXPECT_EQ(shop.controller.give(Command::home).error().reason, "no axis has a home switch");
}

TEST(Homing, ThatIsStoppedLeavesTheAxisWithoutItsPlace) {
  HomingShop shop;
  shop.give(Command::home);
  shop.tick(500);
  shop.give(Command::stop);
  shop.tick_until(State::idle);
  EXPECT_EQ(shop.controller.status().unhomed, 7U);
  const Position at = shop.setpoint.position_mm;
  shop.tick(100);
  EXPECT_EQ(shop.setpoint.position_mm, at);
  shop.home();
  EXPECT_EQ(shop.controller.status().unhomed, 0U);
}

// The planning side has found a place, and the tick side has not taken it.
struct PlacingShop : HomingShop {
  PlacingShop() {
    HomingShop other;
    other.give(Command::home);
    int ticks = 0;
    while (other.tick() == State::homing && !other.controller.has_new_place()) {
      ++ticks;
    }
    give(Command::home);
    tick(ticks);
    controller.plan();
  }
  int places(int ticks) {
    int count = 0;
    for (int i = 0; i < ticks; ++i) {
      tick();
      count += controller.has_new_place() ? 1 : 0;
    }
    return count;
  }
};

TEST(Homing, ThatIsStoppedGivesAPlaceThatIsFoundBeforeItIsIdle) {
  PlacingShop shop;
  shop.give(Command::stop);
  shop.controller.plan();
  EXPECT_EQ(shop.controller.status().state, State::homing);
  shop.tick();
  EXPECT_TRUE(shop.controller.has_new_place());
  EXPECT_EQ(shop.tick(), State::idle);
  EXPECT_EQ(shop.places(100), 0);
}

TEST(Homing, GivesNoPlaceBehindAnEmergencyStopOrAFault) {
  for (const State end : {State::emergency_stop, State::fault}) {
    PlacingShop shop;
    end == State::fault ? shop.controller.fail() : shop.controller.emergency_stop();
    EXPECT_EQ(shop.places(10), 0);
    EXPECT_EQ(shop.controller.status().unhomed, 7U);
    shop.give(Command::reset);
    shop.give(Command::enable);
    shop.give(Command::home);
    EXPECT_EQ(shop.places(10), 0);
    shop.tick_until(State::idle);
    EXPECT_EQ(shop.controller.status().unhomed, 0U);
  }
}

// The setpoint is the true place here, so that a switch is where the machine file says; the place
// that homing gives is off by what the tick of the contact may be off, and by nothing else.
TEST(Homing, WorksWithTheTicksInAThreadOfTheirOwn) {
  const MachineSettings settings = mill_with_switches();
  Controller controller(settings);
  std::atomic<bool> over = false;
  std::atomic<int> places = 0;
  std::thread ticks([&] {
    Shop shop(settings);  // for its switches
    while (!over) {
      controller.tick(shop.setpoint);
      places += controller.has_new_place() ? 1 : 0;
      controller.set_home_switches(shop.closed());
      std::this_thread::sleep_for(std::chrono::microseconds(5));
    }
  });
  ASSERT_TRUE(controller.give(Command::enable));
  ASSERT_TRUE(controller.give(Command::home));
  while (controller.status().state == State::homing) {
    controller.plan();
  }
  over = true;
  ticks.join();
  EXPECT_EQ(controller.status().state, State::idle);
  EXPECT_EQ(controller.status().unhomed, 0U);
  EXPECT_EQ(places, 3);
  for (const double at_mm : controller.status().setpoint.position_mm) {
    EXPECT_NEAR(at_mm, -100.0, 1e-9);
  }
}

// A search for the switches whose ticks come while the controller looks at them, as those of
// another thread may: at random in the first run, in a later one where the looks of the first say
// so.
class TickedInLooks {
 public:
  explicit TickedInLooks(unsigned seed) : random_(seed), repeats_(false) {}
  explicit TickedInLooks(std::vector<std::int64_t> looks)
      : repeats_(true), looks_(std::move(looks)) {}

  void home() {
    KernelOptions options;
    options.plan_clock = [this](std::int64_t ticks) {
      return repeats_ ? repeat(ticks) : note(ticks);
    };
    Controller controller(shop_.machine, options);
    controller_ = &controller;
    EXPECT_TRUE(controller.give(Command::enable));
    EXPECT_TRUE(controller.give(Command::home));
    while (controller.status().state == State::homing && places_mm.size() < kMostTicks) {
      controller.plan();
      if (!repeats_) {
        tick();
      }
    }
    ASSERT_EQ(controller.status().state, State::idle);
    EXPECT_EQ(controller.status().unhomed, 0U);
  }
  [[nodiscard]] std::vector<std::int64_t> looks() const { return looks_; }

  std::vector<Position> places_mm;
  int taken_back = 0;

 private:
  static constexpr std::size_t kMostTicks = 100'000;

  void tick() {
    controller_->tick(shop_.setpoint);
    places_mm.push_back(shop_.setpoint.position_mm);
    controller_->set_home_switches(shop_.closed());
  }
  bool note(std::int64_t ticks) {
    if (ticks < 0) {
      looks_.pop_back();
      ++taken_back;
      return true;
    }
    looks_.push_back(ticks);
    const bool is_of_controller = ticks == static_cast<std::int64_t>(places_mm.size());
    if (controller_ != nullptr && is_of_controller && random_() % 8 == 0) {
      tick();
    }
    return true;
  }
  bool repeat(std::int64_t ticks) {
    EXPECT_GE(ticks, 0);
    if (next_ < looks_.size() && looks_[next_] == ticks) {
      ++next_;
      return true;
    }
    tick();
    return places_mm.size() > kMostTicks;
  }

  std::mt19937 random_;
  bool repeats_;
  std::vector<std::int64_t> looks_;
  std::size_t next_ = 0;
  Shop shop_{mill_with_switches()};  // for its switches; its own controller rests
  Controller* controller_ = nullptr;
};

// Found with eight runs beside each other: one of ten was not repeated from its record.
TEST(Homing, IsRepeatedByTheLooksOfPlanningWhereverTicksCameBetween) {
  int taken_back = 0;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    TickedInLooks first(seed);
    first.home();
    taken_back += first.taken_back;
    TickedInLooks again(first.looks());
    again.home();
    first.places_mm.resize(std::min(first.places_mm.size(), again.places_mm.size()));
    EXPECT_GT(first.places_mm.size(), 1000U);
    again.places_mm.resize(first.places_mm.size());
    ASSERT_EQ(first.places_mm, again.places_mm);
  }
  EXPECT_GT(taken_back, 0);
}

TEST(Homing, IsAskedForAgainBehindAFault) {
  HomingShop shop;
  shop.home();
  shop.controller.fail();
  EXPECT_EQ(shop.controller.status().unhomed, 7U);
}

}  // namespace
}  // namespace kerf::test
