// What the simulated table does with setpoints that are in order.
#include "machine/simulated_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/machine/tables.hpp"

namespace {

using kerf::AxisDrive;
using kerf::TableSettings;
using kerf::curves::Position;
using kerf::machine::DriveFault;
using kerf::machine::MachineState;
using kerf::machine::SimulatedTable;
using kerf::machine::test::at;
using kerf::machine::test::kTick;
using kerf::machine::test::lagging;
using kerf::machine::test::real;

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
    ASSERT_EQ(state.fault, DriveFault::none);
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
  table.enable({.mm = {circle.radius_mm, 0.0, 0.0}});
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

TEST(SimulatedTable, DoesTheSameToTheLastBitInASecondRun) {
  const auto run = [](SimulatedTable& table) {
    std::vector<MachineState> states;
    table.enable({.mm = {10.0, 0.0, 0.0}});
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

}  // namespace
