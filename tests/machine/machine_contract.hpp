// What every machine owes (docs/machine-interface.md): tests for those who instantiate them.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include <gtest/gtest.h>

#include "machine/machine.hpp"

namespace kerf::machine::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

struct NamedMaker {
  const char* name;
  std::function<std::unique_ptr<Machine>()> make;
};

class MachineContract : public testing::TestWithParam<NamedMaker> {
 protected:
  std::unique_ptr<Machine> machine_ = GetParam().make();
};

inline const AxisPlaces kPlaces{.mm = {1.0, 2.0, 3.0},
                                .extra_rad_mm = {0.1, 0.2, 0.3, 4.0, 5.0, 6.0}};

inline Setpoint at_places(const AxisPlaces& places) {
  return {.position_mm = places.mm, .extra_rad_mm = places.extra_rad_mm};
}

inline bool all_are(const MachineState& state, AxisState wanted) {
  return std::all_of(state.axes.begin(), state.axes.end(),
                     [wanted](AxisState axis) { return axis == wanted; });
}

TEST_P(MachineContract, IsOffUntilItIsEnabled) {
  machine_->write(at_places(kPlaces));
  EXPECT_EQ(machine_->read().fault, DriveFault::not_enabled);
  EXPECT_TRUE(all_are(machine_->read(), AxisState::off));
}

TEST_P(MachineContract, IsEnabledWithAllNineAxesWhereItIsTold) {
  machine_->enable(kPlaces);
  const MachineState state = machine_->read();
  EXPECT_EQ(state.fault, DriveFault::none);
  EXPECT_TRUE(all_are(state, AxisState::on));
  EXPECT_EQ(state.extra_rad_mm, kPlaces.extra_rad_mm);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(state.actual_mm[axis], kPlaces.mm[axis], 1e-3);
  }
}

TEST_P(MachineContract, RefusesToBeEnabledWhereNoAxisCanBe) {
  for (std::size_t axis = 0; axis < kAllAxes; ++axis) {
    AxisPlaces places = kPlaces;
    (axis < 3 ? places.mm[axis] : places.extra_rad_mm[axis - 3]) = kNaN;
    machine_->enable(places);
    EXPECT_EQ(machine_->read().fault, DriveFault::not_finite) << axis;
    EXPECT_EQ(machine_->read().fault_axis, static_cast<std::int8_t>(axis));
  }
}

TEST_P(MachineContract, HasNothingAgainstMotionInItsInputsWhereAllIsWell) {
  machine_->enable(kPlaces);
  machine_->write(at_places(kPlaces));
  const MachineInputs inputs = machine_->read().inputs;
  EXPECT_FALSE(inputs.door_open || inputs.emergency_loop_open || inputs.probe);
  EXPECT_TRUE(inputs.tool_changed && inputs.spindle_at_speed);
  EXPECT_EQ(inputs.lower_limit | inputs.upper_limit, 0);
}

TEST_P(MachineContract, TakesAllNineAxesAndTheOutputsOfASetpoint) {
  machine_->enable(kPlaces);
  Setpoint setpoint = at_places(kPlaces);
  setpoint.extra_rad_mm[4] += 0.01;
  setpoint.position_mm[2] += 0.01;
  setpoint.outputs.digital = 5;
  for (int tick = 0; tick < 1000; ++tick) {
    machine_->write(setpoint);
  }
  const MachineState state = machine_->read();
  EXPECT_NEAR(state.actual_mm[2], setpoint.position_mm[2], 2e-3);
  EXPECT_NEAR(state.extra_rad_mm[4], setpoint.extra_rad_mm[4], 1e-12);
  EXPECT_EQ(state.outputs.digital, 5U);
  EXPECT_EQ(state.fault, DriveFault::none);
}

TEST_P(MachineContract, AfterAFaultAllAxesAreOffAndStayWhereTheyAre) {
  machine_->enable(kPlaces);
  AxisPlaces nowhere = kPlaces;
  nowhere.extra_rad_mm[5] = kNaN;
  machine_->write(at_places(nowhere));
  EXPECT_EQ(machine_->read().fault, DriveFault::not_finite);
  AxisPlaces elsewhere = kPlaces;
  elsewhere.mm[0] += 1.0;
  for (int tick = 0; tick < 1000; ++tick) {
    machine_->write(at_places(elsewhere));
  }
  EXPECT_TRUE(all_are(machine_->read(), AxisState::off));
  EXPECT_NEAR(machine_->read().actual_mm[0], kPlaces.mm[0], 2e-3);
  EXPECT_EQ(machine_->read().extra_rad_mm, kPlaces.extra_rad_mm);
  EXPECT_EQ(machine_->read().fault, DriveFault::not_finite);
  machine_->enable(elsewhere);
  EXPECT_EQ(machine_->read().fault, DriveFault::none);
}

TEST_P(MachineContract, DisabledInMotionAllAxesComeToRestTogether) {
  machine_->enable({});
  for (int tick = 1; tick <= 100; ++tick) {
    machine_->write(at_places({.mm = {0.0005 * tick * tick, 0.00025 * tick * tick, 0.0}}));
  }
  machine_->disable();
  EXPECT_EQ(machine_->read().fault, DriveFault::not_enabled);
  EXPECT_EQ(machine_->read().axes[0], AxisState::stopping);
  for (int tick = 0; tick < 200; ++tick) {
    machine_->write(at_places({}));
  }
  EXPECT_TRUE(all_are(machine_->read(), AxisState::off));
  // On along the line until rest: 100 mm/s ends within 5 mm.
  EXPECT_GT(machine_->read().actual_mm[0], 4.5);
  EXPECT_LT(machine_->read().actual_mm[0], 10.0);
}

TEST_P(MachineContract, AFaultOutlastsDisabling) {
  machine_->enable({});
  machine_->write(at_places({.mm = {kNaN, 0.0, 0.0}}));
  machine_->disable();
  EXPECT_EQ(machine_->read().fault, DriveFault::not_finite);
}

}  // namespace kerf::machine::test
