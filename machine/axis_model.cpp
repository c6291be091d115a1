#include "machine/axis_model.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace kerf::machine {
namespace {

constexpr double kLongestSubstepS = 50e-6;
constexpr double kRestMmS = 1e-15;

// To the nearest whole number, ties to even, for |value| below 2^51: the sum has no bits left for a
// fraction. std::nearbyint is a call on plain x86-64.
double nearest_whole(double value) {
  constexpr double kNoFraction = 6755399441055744.0;  // 1.5 * 2^52
  return (value + kNoFraction) - kNoFraction;
}

}  // namespace

AxisModel::AxisModel(const AxisDrive& drive, double period_s) noexcept
    : drive_(drive),
      healthy_(drive),
      period_s_(period_s),
      substeps_(std::max(1, static_cast<int>(std::ceil(period_s / kLongestSubstepS - 1e-9)))),
      substep_s_(period_s / substeps_),
      substeps_per_s_(substeps_ / period_s),
      resolution_mm_(drive.screw_lead_mm / drive.counts_per_rev),
      counts_per_mm_(drive.counts_per_rev / drive.screw_lead_mm),
      time_constant_s_(1.0 / (drive.velocity_gain_per_s + drive.viscous_friction_per_s)),
      decay_(-std::expm1(-substep_s_ / time_constant_s_)) {}

void AxisModel::reset(double position_mm) noexcept {
  drive_ = healthy_;
  command_mm_ = position_mm;
  position_mm_ = position_mm;
  velocity_mm_s_ = 0.0;
  integral_mm_s2_ = 0.0;
  failure_ = EncoderFailure::none;
  begin_stop(0.0);
}

void AxisModel::follow(double setpoint_mm) noexcept {
  const Way way = way_to(setpoint_mm);
  for (int i = 0; i < substeps_; ++i) {
    follow_substep(way, i);
  }
  command_mm_ = setpoint_mm;
}

void AxisModel::follow_together(std::array<AxisModel, 3>& axes,
                                const std::array<double, 3>& setpoints_mm) noexcept {
  assert(axes[0].substeps_ == axes[1].substeps_ && axes[0].substeps_ == axes[2].substeps_);
  const std::array ways{axes[0].way_to(setpoints_mm[0]), axes[1].way_to(setpoints_mm[1]),
                        axes[2].way_to(setpoints_mm[2])};
  for (int i = 0; i < axes[0].substeps_; ++i) {
    axes[0].follow_substep(ways[0], i);
    axes[1].follow_substep(ways[1], i);
    axes[2].follow_substep(ways[2], i);
  }
  for (std::size_t k = 0; k < axes.size(); ++k) {
    axes[k].command_mm_ = setpoints_mm[k];
  }
}

AxisModel::Way AxisModel::way_to(double setpoint_mm) const noexcept {
  return {
      .step_mm = (setpoint_mm - command_mm_) / substeps_,
      .fed_forward_mm_s = drive_.feed_forward * (setpoint_mm - command_mm_) / period_s_,
  };
}

void AxisModel::follow_substep(const Way& way, int i) noexcept {
  const double error_mm = command_mm_ + way.step_mm * i - encoder_mm();
  substep(drive_.position_gain_per_s * error_mm + way.fed_forward_mm_s);
}

void AxisModel::begin_stop(double ramp_s) noexcept {
  stop_from_mm_s_ = velocity_mm_s_;
  stop_left_ = ramp_s > 0.0 ? 1.0 : 0.0;
  stop_step_ = ramp_s > 0.0 ? substep_s_ / ramp_s : 0.0;
}

void AxisModel::stop() noexcept {
  for (int i = 0; i < substeps_; ++i) {
    stop_left_ = std::max(0.0, stop_left_ - stop_step_);
    integral_mm_s2_ = 0.0;  // what it holds would push on after the ramp
    substep(stop_from_mm_s_ * stop_left_);
  }
}

void AxisModel::fail_encoder(EncoderFailure failure, double jump_mm) noexcept {
  failure_ = EncoderFailure::none;
  frozen_mm_ = encoder_mm();
  failure_ = failure;
  jump_mm_ = jump_mm;
}

void AxisModel::weaken() noexcept {
  constexpr double kShareOfFriction = 0.5;
  drive_.drive_acceleration_mm_s2 =
      std::min(drive_.drive_acceleration_mm_s2, kShareOfFriction * drive_.coulomb_friction_mm_s2);
}

// It sticks to friction that nothing overcomes.
void AxisModel::jam() noexcept {
  velocity_mm_s_ = 0.0;
  drive_.coulomb_friction_mm_s2 = std::numeric_limits<double>::infinity();
}

double AxisModel::encoder_mm() const noexcept {
  switch (failure_) {
    case EncoderFailure::frozen:
      return frozen_mm_;
    case EncoderFailure::not_finite:
      return std::numeric_limits<double>::quiet_NaN();
    case EncoderFailure::jumped:
      return whole_counts_mm() + jump_mm_;
    case EncoderFailure::none:
      break;
  }
  return whole_counts_mm();
}

double AxisModel::whole_counts_mm() const noexcept {
  return resolution_mm_ > 0.0 ? nearest_whole(position_mm_ * counts_per_mm_) * resolution_mm_
                              : position_mm_;
}

double AxisModel::stopping_time_s() const noexcept {
  return 2.0 * std::abs(velocity_mm_s_) / healthy_.drive_acceleration_mm_s2;
}

void AxisModel::substep(double velocity_command_mm_s) noexcept {
  // A command that is not a number (a dead encoder) commands rest; the table faults on it.
  const double limit_mm_s = drive_.drive_velocity_mm_s;
  const double command_mm_s = velocity_command_mm_s == velocity_command_mm_s
                                  ? std::clamp(velocity_command_mm_s, -limit_mm_s, limit_mm_s)
                                  : 0.0;
  const double v = velocity_mm_s_;
  const double drive_mm_s2 = drive_.velocity_gain_per_s * command_mm_s + integral_mm_s2_;
  const double coulomb_mm_s2 = drive_.coulomb_friction_mm_s2;
  if (v == 0.0 && std::abs(drive_mm_s2) <= coulomb_mm_s2) {  // sticks
    integrate(command_mm_s, drive_mm_s2);
    return;
  }
  const double friction_mm_s2 = std::copysign(coulomb_mm_s2, v != 0.0 ? v : drive_mm_s2);

  // v' = (settled - v) / time constant over the sub-step, then the motor's mean torque over it.
  const double settled_mm_s = (drive_mm_s2 - friction_mm_s2) * time_constant_s_;
  double change_mm_s = (settled_mm_s - v) * decay_;
  double moved_mm = settled_mm_s * substep_s_ - change_mm_s * time_constant_s_;
  double motor_mm_s2 =
      (change_mm_s + drive_.viscous_friction_per_s * moved_mm) * substeps_per_s_ + friction_mm_s2;
  if (std::abs(motor_mm_s2) > drive_.drive_acceleration_mm_s2) {
    const double viscous_per_s = drive_.viscous_friction_per_s;
    motor_mm_s2 = std::copysign(drive_.drive_acceleration_mm_s2, motor_mm_s2);
    change_mm_s = (motor_mm_s2 - friction_mm_s2 - viscous_per_s * v) * substep_s_ /
                  (1.0 + 0.5 * viscous_per_s * substep_s_);
    moved_mm = (v + 0.5 * change_mm_s) * substep_s_;
  }
  integrate(command_mm_s - v, motor_mm_s2);
  position_mm_ += moved_mm;
  velocity_mm_s_ = v + change_mm_s;
  // Dry friction brings the axis to rest, it never turns it round. A speed that only decays is
  // cut off before it becomes a denormal number, which is slow to compute with.
  const bool turned_by_friction = coulomb_mm_s2 > 0.0 && velocity_mm_s_ * v < 0.0;
  if (turned_by_friction || std::abs(velocity_mm_s_) < kRestMmS) {
    velocity_mm_s_ = 0.0;
  }
}

// The integral does not wind up while the motor is saturated in its direction.
void AxisModel::integrate(double velocity_error_mm_s, double motor_mm_s2) noexcept {
  const bool saturated = std::abs(motor_mm_s2) >= drive_.drive_acceleration_mm_s2;
  if (!saturated || motor_mm_s2 * velocity_error_mm_s < 0.0) {
    integral_mm_s2_ += drive_.velocity_integral_per_s2 * velocity_error_mm_s * substep_s_;
  }
}

}  // namespace kerf::machine
