#include "machine/simulated_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace {

using kerf::curves::Position;
using kerf::interp::Setpoint;
using kerf::machine::AxisDrive;
using kerf::machine::EncoderFailure;
using kerf::machine::Fault;
using kerf::machine::MachineState;
using kerf::machine::SimulatedTable;
using kerf::machine::TableSettings;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTick = 0.001;

TableSettings table_of(const AxisDrive& drive) {
  TableSettings settings{.period_s = kTick};
  settings.axes.fill(drive);
  return settings;
}

// Linear loops that lag: no quantisation, friction or feed-forward, no saturation within reach.
TableSettings lagging() {
  return table_of({.travel = {.min_mm = -300.0, .max_mm = 300.0},
                   .drive_velocity_mm_s = 1e5,
                   .drive_acceleration_mm_s2 = 1e8,
                   .counts_per_rev = std::numeric_limits<double>::infinity(),
                   .position_gain_per_s = 150.0,
                   .velocity_gain_per_s = 1500.0,
                   .velocity_integral_per_s2 = 0.0,
                   .feed_forward = 0.0,
                   .coulomb_friction_mm_s2 = 0.0,
                   .viscous_friction_per_s = 0.0});
}

// A real table: friction, encoders, limits.
TableSettings real() {
  return table_of({.travel = {.min_mm = -300.0, .max_mm = 300.0},
                   .position_gain_per_s = 150.0,
                   .velocity_gain_per_s = 1500.0,
                   .velocity_integral_per_s2 = 20e3,
                   .feed_forward = 0.9,
                   .coulomb_friction_mm_s2 = 300.0,
                   .viscous_friction_per_s = 5.0});
}

Setpoint at(const Position& position_mm) {
  return {.position_mm = position_mm};
}

// Along a straight line from the origin at a constant speed.
Position on_line(const Position& direction, double length_mm) {
  return {direction[0] * length_mm, direction[1] * length_mm, direction[2] * length_mm};
}

TEST(SimulatedTable, HasNoContourErrorOnALineWithMatchedAxes) {
  SimulatedTable table(lagging());
  table.enable({});
  const Position direction{2.0 / 7.0, -6.0 / 7.0, 3.0 / 7.0};
  double lag_mm = 0.0;
  for (int tick = 1; tick <= 1500; ++tick) {
    const double t = tick * kTick;
    table.write(at(on_line(direction, 50.0 * t * t)));  // up to 150 mm/s
    const MachineState state = table.read();
    ASSERT_EQ(state.fault, Fault::none);
    EXPECT_LT(state.contour_error_mm, 1e-10);
    lag_mm = std::max(lag_mm, std::abs(state.following_error_mm[1]));
  }
  EXPECT_GT(lag_mm, 0.5);  // far behind, but on the path
}

TEST(SimulatedTable, MismatchedAxesLeaveALineByTheDifferenceOfTheirLags) {
  TableSettings settings = lagging();
  settings.axes[0].position_gain_per_s = 100.0;
  settings.axes[1].position_gain_per_s = 80.0;
  SimulatedTable table(settings);
  table.enable({});
  const double half = std::numbers::sqrt2 / 2.0;
  for (int tick = 1; tick <= 1000; ++tick) {
    table.write(at(on_line({half, half, 0.0}, 0.1 * tick)));
  }
  const double expected_mm = 0.5 * 100.0 * (1.0 / 80.0 - 1.0 / 100.0);
  EXPECT_NEAR(table.read().contour_error_mm, expected_mm, 1e-9);
  EXPECT_NEAR(table.read().following_error_mm[0], 100.0 * half / 100.0, 1e-9);
  EXPECT_NEAR(table.read().following_error_mm[1], 100.0 * half / 80.0, 1e-9);
}

// Mean radius of the actual circle, minus the commanded one, in the steady state.
struct Circle {
  double radius_mm = 10.0;
  double speed_mm_s = 100.0;
};
struct CircleErrors {
  double radial_mm = 0.0;
  double contour_mm = 0.0;
};
CircleErrors run_circle(const TableSettings& settings, const Circle& circle) {
  SimulatedTable table(settings);
  table.enable({circle.radius_mm, 0.0, 0.0});
  const double omega = circle.speed_mm_s / circle.radius_mm;
  CircleErrors errors;
  for (int tick = 1; tick <= 3000; ++tick) {
    const double angle = omega * tick * kTick;
    table.write(at({circle.radius_mm * std::cos(angle), circle.radius_mm * std::sin(angle), 0.0}));
    if (tick > 2000) {
      const MachineState state = table.read();
      errors.radial_mm +=
          (std::hypot(state.actual_mm[0], state.actual_mm[1]) - circle.radius_mm) / 1000.0;
      errors.contour_mm += state.contour_error_mm / 1000.0;
    }
  }
  return errors;
}

// |X/R| - 1 of the loop Kp (ff s + Kv) / (s^2 + Kp s + Kp Kv) at s = i omega.
double amplitude_error(const AxisDrive& drive, double omega) {
  const double kp = drive.velocity_gain_per_s;
  const double kv = drive.position_gain_per_s;
  return kp * std::hypot(drive.feed_forward * omega, kv) /
             std::hypot(kp * kv - omega * omega, kp * omega) -
         1.0;
}

TEST(SimulatedTable, MakesCirclesTooSmallOrTooLargeByTheAmplitudeOfItsLoop) {
  for (const double feed_forward : {0.0, 0.6, 1.0}) {
    for (const Circle& circle : {Circle{.radius_mm = 10.0, .speed_mm_s = 100.0},
                                 Circle{.radius_mm = 20.0, .speed_mm_s = 400.0}}) {
      TableSettings settings = lagging();
      for (AxisDrive& axis : settings.axes) {
        axis.feed_forward = feed_forward;
        axis.max_following_error_mm = 10.0;
      }
      const double omega = circle.speed_mm_s / circle.radius_mm;
      const double expected_mm = circle.radius_mm * amplitude_error(settings.axes[0], omega);
      // The axes run on chords: a sagitta of R (omega Ts)^2 / 8. The loop samples every 50 us.
      const double chord_mm = circle.radius_mm * std::pow(omega * kTick, 2) / 8.0;
      const double tolerance_mm = chord_mm + 0.01 * std::abs(expected_mm);
      const CircleErrors errors = run_circle(settings, circle);
      EXPECT_NEAR(errors.radial_mm, expected_mm, tolerance_mm) << feed_forward;
      EXPECT_NEAR(errors.contour_mm, std::abs(expected_mm), tolerance_mm) << feed_forward;
    }
  }
}

TEST(SimulatedTable, SettlesOnTheProgrammedPointInADwell) {
  SimulatedTable table(lagging());
  table.enable({});
  for (int tick = 0; tick < 500; ++tick) {
    table.write(at({1.0, -2.0, 3.0}));
  }
  const MachineState state = table.read();
  EXPECT_NEAR(state.actual_mm[2], 3.0, 1e-9);
  EXPECT_NEAR(state.contour_error_mm, 0.0, 1e-9);
}

TEST(SimulatedTable, ReportsWholeEncoderCounts) {
  SimulatedTable table(real());
  table.enable({});
  for (int tick = 1; tick <= 200; ++tick) {
    table.write(at({0.0371 * tick, 0.0113 * tick, 0.0}));
    for (const double actual_mm : table.read().actual_mm) {
      EXPECT_NEAR(actual_mm * 1000.0, std::round(actual_mm * 1000.0), 1e-9);
    }
  }
}

TEST(SimulatedTable, TakesNothingBeforeItIsEnabled) {
  SimulatedTable table(lagging());
  EXPECT_EQ(table.read().fault, Fault::not_enabled);
  table.write(at({1.0, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, Fault::not_enabled);
  EXPECT_EQ(table.read().actual_mm[0], 0.0);
  table.enable({});
  EXPECT_EQ(table.read().fault, Fault::none);
}

TEST(SimulatedTable, CannotBeEnabledWithSettingsThatAreNotValid) {
  TableSettings settings = lagging();
  settings.axes[1].screw_lead_mm = 0.0;
  SimulatedTable table(settings);
  table.enable({});
  EXPECT_EQ(table.read().fault, Fault::not_enabled);
}

TEST(SimulatedTable, FaultsAtTheVeryTickThatLeavesTheTravel) {
  SimulatedTable table(lagging());
  table.enable({299.0, 0.0, 0.0});
  table.write(at({300.0 + 0.5e-6, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, Fault::none);
  table.write(at({300.0 + 2e-6, 0.0, 0.0}));
  EXPECT_EQ(table.read().fault, Fault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 0);

  table.enable({});
  table.write(at({0.0, 0.0, -300.1}));
  EXPECT_EQ(table.read().fault, Fault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 2);
}

TEST(SimulatedTable, FaultsOnAnythingInASetpointThatIsNotFinite) {
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
      EXPECT_EQ(table.read().fault, Fault::not_finite) << field;
      EXPECT_EQ(table.read().fault_axis, field < 3 ? 1 : -1) << field;
      for (const double actual_mm : table.read().actual_mm) {
        EXPECT_TRUE(std::isfinite(actual_mm));
      }
      EXPECT_TRUE(std::isfinite(table.read().contour_error_mm));
    }
  }
}

TEST(SimulatedTable, CannotBeEnabledAtAPointThatIsNotFinite) {
  SimulatedTable table(real());
  table.enable({0.0, 0.0, kNaN});
  EXPECT_EQ(table.read().fault, Fault::not_finite);
  EXPECT_EQ(table.read().fault_axis, 2);
  EXPECT_TRUE(std::isfinite(table.read().actual_mm[2]));
}

void run_at_speed(SimulatedTable& table, int ticks) {
  table.enable({});
  for (int tick = 1; tick <= ticks; ++tick) {
    const double way_mm = tick < 100 ? 0.0005 * tick * tick : 5.0 + 0.1 * (tick - 100);
    table.write(at({way_mm, -0.5 * way_mm, 0.0}));
  }
}

TEST(SimulatedTable, NeverLetsANaNOfAnEncoderThrough) {
  SimulatedTable table(real());
  run_at_speed(table, 200);
  ASSERT_EQ(table.read().fault, Fault::none);
  table.fail_encoder(1, EncoderFailure::not_finite);
  for (int tick = 0; tick < 300; ++tick) {
    table.write(at({15.0, -7.5, 0.0}));
    const MachineState state = table.read();
    EXPECT_EQ(state.fault, Fault::not_finite);
    EXPECT_EQ(state.fault_axis, 1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_TRUE(std::isfinite(state.actual_mm[axis]));
      EXPECT_TRUE(std::isfinite(state.following_error_mm[axis]));
    }
    EXPECT_TRUE(std::isfinite(state.contour_error_mm));
  }
}

TEST(SimulatedTable, NoticesAFrozenEncoderByTheFollowingError) {
  SimulatedTable table(real());
  run_at_speed(table, 200);
  table.fail_encoder(0, EncoderFailure::frozen);
  int ticks = 0;
  for (double way_mm = 15.0; table.read().fault == Fault::none && ticks < 1000; ++ticks) {
    way_mm += 0.1;
    table.write(at({way_mm, -7.5, 0.0}));
  }
  EXPECT_EQ(table.read().fault, Fault::following_error);
  EXPECT_EQ(table.read().fault_axis, 0);
  EXPECT_LE(ticks, 51);  // 5 mm at 0.1 mm a tick
}

TEST(SimulatedTable, FaultsWhenAnAxisCannotFollow) {
  TableSettings settings = real();
  settings.axes[2].drive_acceleration_mm_s2 = 400.0;  // little more than its friction
  settings.axes[2].max_following_error_mm = 0.5;
  SimulatedTable table(settings);
  table.enable({});
  for (int tick = 1; tick <= 300 && table.read().fault == Fault::none; ++tick) {
    table.write(at({0.0, 0.0, 0.0005 * tick * tick}));
  }
  EXPECT_EQ(table.read().fault, Fault::following_error);
  EXPECT_EQ(table.read().fault_axis, 2);
  EXPECT_GT(table.read().following_error_mm[2], 0.5);
}

TEST(SimulatedTable, AfterAFaultAllAxesStopTogetherAndStayWhereTheyAre) {
  SimulatedTable table(real());
  run_at_speed(table, 400);  // 100 and 50 mm/s
  table.write(at({1000.0, 0.0, 0.0}));
  ASSERT_EQ(table.read().fault, Fault::soft_limit);
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
  EXPECT_EQ(table.read().fault, Fault::soft_limit);
  EXPECT_EQ(table.read().actual_mm[2], 0.0);
}

TEST(SimulatedTable, EnablingClearsTheFaultAndMovesAgain) {
  SimulatedTable table(lagging());
  run_at_speed(table, 50);
  table.fail_encoder(0, EncoderFailure::not_finite);
  table.write(at({}));
  ASSERT_EQ(table.read().fault, Fault::not_finite);
  table.enable({7.0, 8.0, 9.0});
  EXPECT_EQ(table.read().fault, Fault::none);
  EXPECT_EQ(table.read().fault_axis, -1);
  EXPECT_EQ(table.read().actual_mm, (Position{7.0, 8.0, 9.0}));
  for (int tick = 0; tick < 500; ++tick) {
    table.write(at({8.0, 8.0, 9.0}));
  }
  EXPECT_NEAR(table.read().actual_mm[0], 8.0, 1e-9);
  EXPECT_EQ(table.read().fault, Fault::none);
}

TEST(SimulatedTable, DoesTheSameToTheLastBitInASecondRun) {
  const auto run = [](SimulatedTable& table) {
    std::vector<MachineState> states;
    table.enable({10.0, 0.0, 0.0});
    for (int tick = 1; tick <= 2000; ++tick) {
      const double angle = 0.01 * tick;
      table.write(at({10.0 * std::cos(angle), 10.0 * std::sin(2.0 * angle), 0.001 * tick}));
      states.push_back(table.read());
    }
    return states;
  };
  SimulatedTable first(real());
  SimulatedTable second(real());
  const auto once = run(first);
  const auto again = run(first);  // the same object, too
  const auto other = run(second);
  for (std::size_t tick = 0; tick < once.size(); ++tick) {
    for (const auto& repeat : {again[tick], other[tick]}) {
      ASSERT_EQ(std::memcmp(&once[tick].actual_mm, &repeat.actual_mm, sizeof(Position)), 0);
      ASSERT_EQ(
          std::memcmp(&once[tick].following_error_mm, &repeat.following_error_mm, sizeof(Position)),
          0);
      ASSERT_EQ(std::memcmp(&once[tick].contour_error_mm, &repeat.contour_error_mm, sizeof(double)),
                0);
    }
  }
}

TEST(SimulatedTable, RefusesToGoToTheEndOfTheWorldWithoutTravelToo) {
  SimulatedTable table(TableSettings{});
  table.enable({});
  table.write(at({0.0, 1e300, 0.0}));
  EXPECT_EQ(table.read().fault, Fault::soft_limit);
  EXPECT_EQ(table.read().fault_axis, 1);
}

}  // namespace
