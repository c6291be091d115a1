// What makes the simulated table fault, and what it does then.
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "machine/simulated_table.hpp"
#include "tests/machine/tables.hpp"

namespace {

using kerf::TableSettings;
using kerf::curves::Position;
using kerf::interp::Setpoint;
using kerf::machine::DriveFault;
using kerf::machine::EncoderFailure;
using kerf::machine::MachineState;
using kerf::machine::SimulatedTable;
using kerf::machine::test::at;
using kerf::machine::test::lagging;
using kerf::machine::test::real;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(SimulatedTableFaults, TakesNothingBeforeItIsEnabled) {
  SimulatedTable table(lagging());
  EXPECT_EQ(table.read().fault, DriveFault::not_enabled);
  table.write(at({1.0, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::not_enabled);
  EXPECT_EQ(table.read().actual_mm[0], 0.0);
  table.enable({});
  EXPECT_EQ(table.read().fault, DriveFault::none);
}

TEST(SimulatedTableFaults, CannotBeEnabledWithSettingsThatAreNotValid) {
  TableSettings settings = lagging();
  settings.axes[1].screw_lead_mm = 0.0;
  SimulatedTable table(settings);
  table.enable({});
  EXPECT_EQ(table.read().fault, DriveFault::not_enabled);
}

TEST(SimulatedTableFaults, FaultsAtTheVeryTickThatLeavesTheTravel) {
  SimulatedTable table(lagging());
  table.enable({.mm = {299.0, 0.0, 0.0}});
  table.write(at({300.0 + 0.5e-6, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::none);
  table.write(at({300.0 + 2e-6, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 0);

  table.enable({});
  table.write(at({0.0, 0.0, -300.1}));
  EXPECT_EQ(table.read().fault, DriveFault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 2);
}

TEST(SimulatedTableFaults, LeavesTheTravelWhereNobodyKnowsYetWhereTheAxisIs) {
  SimulatedTable table(lagging());
  table.enable({.mm = {299.0, 199.0, 0.0}});
  table.set_unhomed(1U << 0U);
  table.write(at({300.1, 199.0, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::none);
  table.set_unhomed(0);
  table.write(at({300.1, 199.0, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 0);
}

TEST(SimulatedTableFaults, FaultsOnAnythingInASetpointThatIsNotFinite) {
  const std::vector<std::function<double&(Setpoint&)>> fields{
      [](Setpoint& s) -> double& { return s.position_mm[1]; },
      [](Setpoint& s) -> double& { return s.velocity_mm_s[1]; },
      [](Setpoint& s) -> double& { return s.acceleration_mm_s2[1]; },
      [](Setpoint& s) -> double& { return s.s_mm; },
      [](Setpoint& s) -> double& { return s.v_mm_s; },
      [](Setpoint& s) -> double& { return s.a_mm_s2; },
      [](Setpoint& s) -> double& { return s.j_mm_s3; }};
  for (std::size_t field = 0; field < fields.size(); ++field) {
    for (const double bad : {kNaN, std::numeric_limits<double>::infinity()}) {
      SimulatedTable table(real());
      table.enable({});
      Setpoint setpoint = at({0.01, 0.01, 0.0});
      fields[field](setpoint) = bad;
      table.write(setpoint);
      EXPECT_EQ(table.read().fault, DriveFault::not_finite) << field;
      EXPECT_EQ(table.read().fault_axis, field < 3 ? 1 : -1) << field;
      for (const double actual_mm : table.read().actual_mm) {
        EXPECT_TRUE(std::isfinite(actual_mm));
      }
      EXPECT_TRUE(std::isfinite(table.read().contour_error_mm));
    }
  }
}

TEST(SimulatedTableFaults, CannotBeEnabledAtAPointThatIsNotFinite) {
  SimulatedTable table(real());
  table.enable({.mm = {0.0, 0.0, kNaN}});
  EXPECT_EQ(table.read().fault, DriveFault::not_finite);
  EXPECT_EQ(table.read().fault_axis, 2);
  EXPECT_TRUE(std::isfinite(table.read().actual_mm[2]));

  table.enable({});
  table.write(at({0.0, 400.0, 0.0}));
  ASSERT_EQ(table.read().fault, DriveFault::soft_limit);
  table.enable({.mm = {kNaN, 0.0, 0.0}});
  EXPECT_EQ(table.read().fault, DriveFault::not_finite);
  EXPECT_EQ(table.read().fault_axis, 0);
}

void run_at_speed(SimulatedTable& table, int ticks) {
  table.enable({});
  for (int tick = 1; tick <= ticks; ++tick) {
    const double way_mm = tick < 100 ? 0.0005 * tick * tick : 5.0 + 0.1 * (tick - 100);
    table.write(at({way_mm, -0.5 * way_mm, 0.0}));
  }
}

TEST(SimulatedTableFaults, NeverLetsANaNOfAnEncoderThrough) {
  SimulatedTable table(real());
  run_at_speed(table, 200);
  ASSERT_EQ(table.read().fault, DriveFault::none);
  table.fail_encoder(1, EncoderFailure::not_finite);
  for (int tick = 0; tick < 300; ++tick) {
    table.write(at({15.0, -7.5, 0.0}));
    const MachineState state = table.read();
    EXPECT_EQ(state.fault, DriveFault::not_finite);
    EXPECT_EQ(state.fault_axis, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(std::isfinite(state.actual_mm[axis]));
      EXPECT_TRUE(std::isfinite(state.following_error_mm[axis]));
    }
    EXPECT_TRUE(std::isfinite(state.contour_error_mm));
  }
}

TEST(SimulatedTableFaults, NoticesAFrozenEncoderByTheFollowingError) {
  SimulatedTable table(real());
  run_at_speed(table, 200);
  table.fail_encoder(0, EncoderFailure::frozen);
  int ticks = 0;
  for (double way_mm = 15.0; table.read().fault == DriveFault::none && ticks < 1000; ++ticks) {
    way_mm += 0.1;
    table.write(at({way_mm, -7.5, 0.0}));
  }
  EXPECT_EQ(table.read().fault, DriveFault::following_error);
  EXPECT_EQ(table.read().fault_axis, 0);
  EXPECT_LE(ticks, 51);  // 5 mm at 0.1 mm a tick
}

TEST(SimulatedTableFaults, FaultsWhenAnAxisCannotFollow) {
  TableSettings settings = real();
  settings.axes[2].drive_acceleration_mm_s2 = 400.0;  // little more than its friction
  settings.axes[2].max_following_error_mm = 0.5;
  SimulatedTable table(settings);
  table.enable({});
  for (int tick = 1; tick <= 300 && table.read().fault == DriveFault::none; ++tick) {
    table.write(at({0.0, 0.0, 0.0005 * tick * tick}));
  }
  EXPECT_EQ(table.read().fault, DriveFault::following_error);
  EXPECT_EQ(table.read().fault_axis, 2);
  EXPECT_GT(table.read().following_error_mm[2], 0.5);
}

TEST(SimulatedTableFaults, AfterAFaultAllAxesStopTogetherAndStayWhereTheyAre) {
  SimulatedTable table(real());
  run_at_speed(table, 400);  // 100 and 50 mm/s
  table.write(at({1000.0, 0.0, 0.0}));
  ASSERT_EQ(table.read().fault, DriveFault::soft_limit);
  Position last_mm = table.read().actual_mm;
  std::array<int, 2> rest{};
  for (int tick = 1; tick <= 200; ++tick) {
    table.write(at({-50.0, 50.0, 50.0}));
    const Position actual_mm = table.read().actual_mm;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (actual_mm[axis] != last_mm[axis]) {
        rest[axis] = tick;
      }
    }
    last_mm = actual_mm;
  }
  // 100 mm/s at half of 20 m/s2 is 10 ticks; the velocity loop lags by 1 / 1500 s.
  EXPECT_GE(rest[0], 9);
  EXPECT_LE(rest[0], 14);
  EXPECT_LE(std::abs(rest[0] - rest[1]), 2);
  EXPECT_EQ(table.read().fault, DriveFault::soft_limit);
  EXPECT_EQ(table.read().actual_mm[2], 0.0);
}

// It comes to rest 0.5 mm beyond the last setpoint.
TEST(SimulatedTableFaults, IsNoFollowingErrorWhereItIsDisabledAtSpeed) {
  TableSettings settings = real();
  settings.axes[0].max_following_error_mm = 0.2;
  SimulatedTable table(settings);
  run_at_speed(table, 400);
  ASSERT_EQ(table.read().fault, DriveFault::none);
  table.disable();
  for (int tick = 0; tick < 50; ++tick) {
    table.write(at({}));
    EXPECT_EQ(table.read().fault, DriveFault::not_enabled);
  }
  EXPECT_LT(table.read().following_error_mm[0], -0.4);
}

TEST(SimulatedTableFaults, EnablingClearsTheFaultAndMovesAgain) {
  SimulatedTable table(lagging());
  run_at_speed(table, 50);
  table.fail_encoder(0, EncoderFailure::not_finite);
  table.write(at({}));
  ASSERT_EQ(table.read().fault, DriveFault::not_finite);
  table.enable({.mm = {7.0, 8.0, 9.0}});
  EXPECT_EQ(table.read().fault, DriveFault::none);
  EXPECT_EQ(table.read().fault_axis, -1);
  EXPECT_EQ(table.read().actual_mm, (Position{7.0, 8.0, 9.0}));
  for (int tick = 0; tick < 500; ++tick) {
    table.write(at({8.0, 8.0, 9.0}));
  }
  EXPECT_NEAR(table.read().actual_mm[0], 8.0, 1e-9);
  EXPECT_EQ(table.read().fault, DriveFault::none);
}

TEST(SimulatedTableFaults, RefusesToGoToTheEndOfTheWorldWithoutTravelToo) {
  SimulatedTable table(TableSettings{});
  table.enable({});
  table.write(at({0.0, 1e300, 0.0}));
  EXPECT_EQ(table.read().fault, DriveFault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 1);
}

}  // namespace
