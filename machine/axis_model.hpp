// One axis of the simulated table: ball screw, encoder, cascaded servo, motor.
//
// The model. A proportional position loop with velocity feed-forward commands a velocity, a PI
// velocity loop commands a torque, and the torque moves the table against friction:
//
//   vc = Kv (r - encoder) + ff r'             |vc| <= drive_velocity
//   m  = Kp (vc - v) + Ki integral(vc - v)    |m|  <= drive_acceleration
//   v' = m - viscous v - coulomb sign(v)      sticks at v = 0 while |m| <= coulomb
//   x' = v
//
// r runs straight from one setpoint to the next within a tick. The position loop sees the encoder,
// which counts in steps of screw_lead / counts_per_rev; the velocity loop sees v itself, as behind
// the speed observer of a drive. Without friction, quantisation and saturation, and with Ki = 0,
//
//   X/R = Kp (ff s + Kv) / (s^2 + Kp s + Kp Kv),   error on a ramp = v (1 - ff) / Kv.
//
// The integration. Sub-steps of at most 50 us, their number fixed by the period, so a tick costs
// the same always. In a sub-step vc and the integral are held, as in a drive of 20 kHz, and the
// linear equation that is left is solved exactly: stable for any gain. Known weakness: a change of
// saturation or of the sign of friction acts from the next sub-step, which costs
// drive_acceleration * 50 us in speed at that place.
//
// The defaults of AxisDrive. Screw and encoder are those of the servo table in [SineSeries]. Gains
// and friction are chosen so that the contour error on the butterfly in the paper's 4.8 s comes
// near the measured one: 20 um at the most and 3.3 um in the mean, measured 20.9 um and 3.9 um.
//
// Called from the tick: nothing here allocates or throws.
#pragma once

#include <array>
#include <cstdint>

#include <kerf/machine.hpp>

namespace kerf::machine {

// Failures of an encoder, for tests of the fault reactions.
enum class EncoderFailure : std::uint8_t { none, frozen, not_finite, jumped };

class AxisModel {
 public:
  // drive must be valid (see is_valid); period_s in 1e-5..0.1.
  AxisModel(const AxisDrive& drive, double period_s) noexcept;

  // Puts the axis at rest there, with empty integrators and nothing broken.
  void reset(double position_mm) noexcept;
  // One tick towards the setpoint.
  void follow(double setpoint_mm) noexcept;
  // The same of three axes of one period, side by side: a sub-step of one waits for its own last
  // one only, so a processor works on all three at once.
  static void follow_together(std::array<AxisModel, 3>& axes,
                              const std::array<double, 3>& setpoints_mm) noexcept;
  // From now on stop(): the velocity goes to 0 along a straight ramp of ramp_s, then stays there.
  // The position loop is open, since its encoder may have failed, and the integral is off.
  void begin_stop(double ramp_s) noexcept;
  void stop() noexcept;  // one tick of it
  [[nodiscard]] bool is_stopped() const noexcept {
    return stop_left_ == 0.0 && velocity_mm_s_ == 0.0;
  }

  // jump_mm: of EncoderFailure::jumped, what it reads too much.
  void fail_encoder(EncoderFailure failure, double jump_mm = 0.0) noexcept;
  // The motor keeps less force than friction has: the axis slows down, and does not move again.
  void weaken() noexcept;
  // It stands at once, whatever the motor does.
  void jam() noexcept;

  [[nodiscard]] double encoder_mm() const noexcept;  // not a number if the encoder failed that way
  [[nodiscard]] double position_mm() const noexcept { return position_mm_; }  // without encoder
  [[nodiscard]] double velocity_mm_s() const noexcept { return velocity_mm_s_; }
  // The time of a ramp to rest with half of the motor's torque.
  [[nodiscard]] double stopping_time_s() const noexcept;

 private:
  // Of a tick.
  struct Way {
    double step_mm = 0.0;  // of the command in a sub-step
    double fed_forward_mm_s = 0.0;
  };
  [[nodiscard]] double whole_counts_mm() const noexcept;
  [[nodiscard]] Way way_to(double setpoint_mm) const noexcept;
  void follow_substep(const Way& way, int i) noexcept;
  void substep(double velocity_command_mm_s) noexcept;
  void integrate(double velocity_error_mm_s, double motor_mm_s2) noexcept;

  AxisDrive drive_;
  AxisDrive healthy_;
  double period_s_;
  int substeps_;
  double substep_s_;
  double substeps_per_s_;
  double resolution_mm_;  // of the encoder, 0: none
  double counts_per_mm_;
  double time_constant_s_;  // of the closed velocity loop
  double decay_;            // 1 - exp(-substep / time constant)

  double command_mm_ = 0.0;
  double position_mm_ = 0.0;
  double velocity_mm_s_ = 0.0;
  double integral_mm_s2_ = 0.0;
  double frozen_mm_ = 0.0;
  double jump_mm_ = 0.0;
  EncoderFailure failure_ = EncoderFailure::none;
  double stop_from_mm_s_ = 0.0;
  double stop_left_ = 0.0;  // of the ramp, 1 at its start, 0 at its end
  double stop_step_ = 0.0;  // of stop_left_ in one sub-step
};

}  // namespace kerf::machine
