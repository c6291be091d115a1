// The axis against the closed forms of its loop.
#include "machine/axis_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace {

using kerf::AxisDrive;
using kerf::machine::AxisModel;
using kerf::machine::EncoderFailure;

constexpr double kTick_s = 0.001;

// No quantisation, no friction, no saturation within reach.
AxisDrive linear_drive() {
  return {.drive_velocity_mm_s = 1e5,
          .drive_acceleration_mm_s2 = 1e8,
          .counts_per_rev = std::numeric_limits<double>::infinity(),
          .position_gain_per_s = 100.0,
          .velocity_gain_per_s = 600.0,
          .velocity_integral_per_s2 = 0.0,
          .feed_forward = 0.0,
          .coulomb_friction_mm_s2 = 0.0,
          .viscous_friction_per_s = 0.0};
}

// Runs at speed long enough for every transient to have died, and returns the following error.
double error_on_ramp(const AxisDrive& drive, double speed_mm_s) {
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  double command_mm = 0.0;
  for (int tick = 1; tick <= 2000; ++tick) {
    command_mm = speed_mm_s * kTick_s * tick;
    axis.follow(command_mm);
  }
  return command_mm - axis.position_mm();
}

TEST(AxisModel, AnswersAStepLikeTheSecondOrderLoop) {
  constexpr double kPeriod = 1e-5;
  const AxisDrive drive = linear_drive();
  AxisModel axis(drive, kPeriod);
  axis.reset(2.0);
  // Poles of s^2 + Kp s + Kp Kv, and the integral of the step response they give. The step takes
  // one tick, so the answer is the mean of the step responses that start within it.
  const double root = std::sqrt(600.0 * 600.0 - 4.0 * 600.0 * 100.0);
  const double p = (600.0 - root) / 2.0;
  const double q = (600.0 + root) / 2.0;
  const auto integral = [&](double t) {
    return t - (q / p * -std::expm1(-p * t) - p / q * -std::expm1(-q * t)) / (q - p);
  };
  double worst = 0.0;
  for (int tick = 1; tick <= 8000; ++tick) {
    axis.follow(3.0);
    const double t = tick * kPeriod;
    const double expected = 2.0 + (integral(t) - integral(t - kPeriod)) / kPeriod;
    worst = std::max(worst, std::abs(axis.position_mm() - expected));
  }
  EXPECT_LT(worst, 1e-3);  // the loop samples every 10 us: Kv * 10 us
  EXPECT_NEAR(axis.position_mm(), 3.0, 1e-3);
}

TEST(AxisModel, LagsOnARampByTheShareOfVelocityNotFedForward) {
  for (const double feed_forward : {0.0, 0.5, 0.9, 1.0}) {
    AxisDrive drive = linear_drive();
    drive.feed_forward = feed_forward;
    EXPECT_NEAR(error_on_ramp(drive, 40.0), 40.0 * (1.0 - feed_forward) / 100.0, 1e-9);
    EXPECT_NEAR(error_on_ramp(drive, -40.0), -40.0 * (1.0 - feed_forward) / 100.0, 1e-9);
  }
}

TEST(AxisModel, FrictionAddsToTheLagUnlessTheIntegralTakesIt) {
  AxisDrive drive = linear_drive();
  drive.coulomb_friction_mm_s2 = 300.0;
  drive.viscous_friction_per_s = 5.0;
  // The torque b v + c comes from Kp (vc - v), vc from Kv e + ff v.
  const double expected = ((5.0 * 40.0 + 300.0) / 600.0 + 40.0) / 100.0;
  EXPECT_NEAR(error_on_ramp(drive, 40.0), expected, 1e-9);
  EXPECT_NEAR(error_on_ramp(drive, -40.0), -expected, 1e-9);
  drive.velocity_integral_per_s2 = 6000.0;
  EXPECT_NEAR(error_on_ramp(drive, 40.0), 0.4, 1e-6);
}

TEST(AxisModel, SticksUntilTheServoPullsHarderThanDryFriction) {
  AxisDrive drive = linear_drive();
  drive.coulomb_friction_mm_s2 = 300.0;
  const double held_mm = 300.0 / (600.0 * 100.0);
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  for (int tick = 0; tick < 500; ++tick) {
    axis.follow(0.999 * held_mm);
  }
  EXPECT_EQ(axis.position_mm(), 0.0);
  for (int tick = 0; tick < 500; ++tick) {
    axis.follow(1.01 * held_mm);
  }
  EXPECT_NEAR(axis.position_mm(), 0.01 * held_mm, 1e-12);  // where it pulls just as hard again
  EXPECT_EQ(axis.velocity_mm_s(), 0.0);
}

TEST(AxisModel, AcceleratesWithTheWholeTorqueAndNoMore) {
  AxisDrive drive = linear_drive();
  drive.drive_acceleration_mm_s2 = 5000.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  for (int tick = 1; tick <= 50; ++tick) {
    axis.follow(1e4);
    const double t = tick * kTick_s;
    if (tick > 1) {  // in the first tick the command is still small
      EXPECT_LE(axis.velocity_mm_s(), 5000.0 * t * (1.0 + 1e-12));
      EXPECT_GT(axis.velocity_mm_s(), 5000.0 * (t - kTick_s));
    }
  }
  // Under constant torque the way between two instants is (v1^2 - v0^2) / 2a.
  const double x = axis.position_mm();
  const double v = axis.velocity_mm_s();
  axis.follow(1e4);
  EXPECT_NEAR(axis.velocity_mm_s() - v, 5.0, 1e-9);
  EXPECT_NEAR(axis.position_mm() - x, (axis.velocity_mm_s() * axis.velocity_mm_s() - v * v) / 10e3,
              1e-9);
}

TEST(AxisModel, FullTorqueAgainstViscousFrictionApproachesItsTerminalSpeed) {
  AxisDrive drive = linear_drive();
  drive.drive_acceleration_mm_s2 = 5000.0;
  drive.viscous_friction_per_s = 40.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  axis.follow(1e4);
  const double v0 = axis.velocity_mm_s();
  for (int tick = 1; tick <= 60; ++tick) {
    axis.follow(1e4);
    const double left = std::exp(-40.0 * tick * kTick_s);
    // The sub-steps take the mean of the friction at their ends: (b h)^2 / 12 * v b t exp(-b t).
    EXPECT_NEAR(axis.velocity_mm_s(), 125.0 + (v0 - 125.0) * left, 2e-5);
  }
}

TEST(AxisModel, NeverRunsFasterThanItsMotor) {
  AxisDrive drive = linear_drive();
  drive.drive_velocity_mm_s = 80.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  double fastest = 0.0;
  for (int tick = 0; tick < 1500; ++tick) {
    axis.follow(100.0);
    fastest = std::max(fastest, axis.velocity_mm_s());
  }
  EXPECT_LE(fastest, 80.0 * (1.0 + 1e-12));
  EXPECT_NEAR(fastest, 80.0, 1e-6);
  EXPECT_NEAR(axis.position_mm(), 100.0, 1e-6);
}

TEST(AxisModel, TheIntegralDoesNotWindUpInSaturation) {
  AxisDrive drive = linear_drive();
  drive.drive_acceleration_mm_s2 = 2000.0;
  drive.drive_velocity_mm_s = 200.0;
  drive.velocity_integral_per_s2 = 20e3;
  drive.position_gain_per_s = 20.0;  // slow enough to brake with this torque
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  double farthest = 0.0;
  for (int tick = 0; tick < 2000; ++tick) {
    axis.follow(50.0);
    farthest = std::max(farthest, axis.position_mm());
  }
  // Held at full torque for tens of ms, an integral that winds up would store hundreds of mm/s.
  EXPECT_LT(farthest, 55.0);
  EXPECT_NEAR(axis.position_mm(), 50.0, 1e-3);
}

TEST(AxisModel, ReadsItsEncoderInWholeCounts) {
  AxisDrive drive = linear_drive();
  drive.screw_lead_mm = 5.0;
  drive.counts_per_rev = 4000.0;
  constexpr double kCount = 5.0 / 4000.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(-1.0);
  for (int tick = 1; tick <= 300; ++tick) {
    axis.follow(-1.0 + 0.0371 * tick);
    const double counts = axis.encoder_mm() / kCount;
    EXPECT_NEAR(counts, std::round(counts), 1e-9);
    EXPECT_LE(std::abs(axis.encoder_mm() - axis.position_mm()), kCount / 2.0 + 1e-12);
  }
  AxisModel fine(linear_drive(), kTick_s);
  fine.reset(0.123456789);
  EXPECT_EQ(fine.encoder_mm(), 0.123456789);
}

TEST(AxisModel, StopsAlongARampAndStaysThere) {
  AxisDrive drive = linear_drive();
  drive.velocity_gain_per_s = 2000.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  for (int tick = 1; tick <= 300; ++tick) {
    axis.follow(0.1 * tick);
  }
  ASSERT_NEAR(axis.velocity_mm_s(), 100.0, 1e-3);
  const double from_mm = axis.position_mm();
  axis.begin_stop(0.05);
  double slowest = axis.velocity_mm_s();
  for (int tick = 0; tick < 70; ++tick) {
    axis.stop();
    EXPECT_LE(axis.velocity_mm_s(), slowest);
    slowest = axis.velocity_mm_s();
  }
  EXPECT_NEAR(axis.velocity_mm_s(), 0.0, 1e-9);
  // Half of 100 mm/s over 50 ms, and the lag of the velocity loop: 100 / 2000.
  EXPECT_NEAR(axis.position_mm() - from_mm, 2.5 + 0.05, 5e-3);
}

TEST(AxisModel, DryFrictionBringsItToRestAndNotBack) {
  AxisDrive drive = linear_drive();
  drive.position_gain_per_s = 0.01;
  drive.velocity_gain_per_s = 0.01;
  drive.feed_forward = 1.0;
  drive.coulomb_friction_mm_s2 = 1000.0;
  drive.drive_acceleration_mm_s2 = 1e5;
  drive.velocity_gain_per_s = 300.0;
  AxisModel axis(drive, kTick_s);
  axis.reset(0.0);
  for (int tick = 1; tick <= 300; ++tick) {
    axis.follow(0.05 * tick);
  }
  ASSERT_GT(axis.velocity_mm_s(), 40.0);
  axis.begin_stop(0.0);
  for (int tick = 0; tick < 200; ++tick) {
    axis.stop();
    ASSERT_GE(axis.velocity_mm_s(), 0.0);
  }
  EXPECT_EQ(axis.velocity_mm_s(), 0.0);
}

TEST(AxisModel, StaysStableWithAnyGainOfTheInnerLoop) {
  for (const double gain : {1e3, 1e4, 1e5, 1e7}) {
    AxisDrive drive = linear_drive();
    drive.velocity_gain_per_s = gain;
    EXPECT_NEAR(error_on_ramp(drive, 40.0), 0.4, 1e-6) << gain;
  }
}

TEST(AxisModel, ABrokenEncoderReadsWhatItShould) {
  AxisModel axis(linear_drive(), kTick_s);
  axis.reset(0.0);
  axis.follow(1.0);
  const double before_mm = axis.encoder_mm();
  axis.fail_encoder(EncoderFailure::frozen);
  axis.follow(2.0);
  EXPECT_EQ(axis.encoder_mm(), before_mm);
  EXPECT_GT(axis.position_mm(), before_mm);
  axis.fail_encoder(EncoderFailure::not_finite);
  axis.follow(3.0);
  EXPECT_TRUE(std::isnan(axis.encoder_mm()));
  EXPECT_TRUE(std::isfinite(axis.position_mm()));
  axis.reset(5.0);
  EXPECT_EQ(axis.encoder_mm(), 5.0);
}

}  // namespace
