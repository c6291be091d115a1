// Turns planned motion into setpoints: one call, one tick.
#pragma once

#include <atomic>
#include <cstdint>
#include <optional>

#include "interp/emergency_brake.hpp"
#include "interp/inquiry_watch.hpp"
#include "interp/motion_queue.hpp"
#include "interp/plan_in_force.hpp"
#include "interp/setpoint.hpp"
#include "interp/tick_chord.hpp"

namespace kerf::interp {

// The tick is absolute: the n-th setpoint lies at s(n period) on the curve, so errors do not
// accumulate. next() allocates nothing, takes no lock, throws nothing; its work is bounded by what
// the queue can hold.
class Interpolator {
 public:
  // Rests at start_mm and start_extra_rad_mm until the first motion. limits: for an emergency stop.
  Interpolator(MotionQueue& queue, double period_s, const Position& start_mm,
               const curves::AuxiliaryPosition& start_extra_rad_mm = {},
               const MachineLimits& limits = {}) noexcept;

  // What the machine has switched; before the first next().
  void begin_with(const Outputs& outputs) noexcept;

  TickStatus next(Setpoint& setpoint) noexcept;

  // From the next tick on the tool brakes as fast as the limits of acceleration allow, on the path
  // (EmergencyBrake), spindle and coolant off. Then the status is emergency_stop, for ever. Any
  // thread.
  void emergency_stop() noexcept { emergency_.store(true, std::memory_order_relaxed); }
  // Of the programmed speed, once take_spindle_override() is called. Any thread.
  void override_spindle_by(double share) noexcept {
    spindle_override_.store(share, std::memory_order_relaxed);
  }
  // From the next tick on. Of the thread that calls next().
  void take_spindle_override() noexcept {
    spindle_share_ = spindle_override_.load(std::memory_order_relaxed);
  }
  [[nodiscard]] bool is_emergency() const noexcept {
    return emergency_.load(std::memory_order_relaxed);
  }

  // What the program asks the machine. Inputs are set before each next().
  [[nodiscard]] InquiryWatch& watch() noexcept { return watch_; }

  // Phase::wait of the present rest. Of the thread that calls next().
  [[nodiscard]] std::uint32_t wait() const noexcept { return phase_.wait; }
  [[nodiscard]] WaitCause wait_cause() const noexcept {
    return phase_.wait != 0 ? phase_.wait_cause : WaitCause::none;
  }

  // The latest tick rested for what the machine has not answered. Of the same thread.
  [[nodiscard]] bool rests_for_machine() const noexcept { return rests_for_machine_; }

  // Setpoint::s_mm of the latest tick. Any thread.
  [[nodiscard]] double reached_path_mm() const noexcept {
    return reached_path_mm_.load(std::memory_order_relaxed);
  }

  // Removes phases that end before the next tick from the queue, to make room. True: the queue is
  // used up and the next tick needs more. The tick itself is not affected.
  bool pass_what_is_over() noexcept;
  // The next tick lies after the queue's end, and the machine is not asked for what follows.
  bool needs_plan() noexcept;

  // The tick of the next setpoint in the plan's time, which stands still while starved. May be read
  // by the planning thread.
  [[nodiscard]] std::int64_t plan_tick() const noexcept {
    return plan_tick_.load(std::memory_order_acquire);
  }

  // May be read by the planning thread.
  [[nodiscard]] PlanInForce::Answer answer() const noexcept { return plan_.answer(); }

  // The latest run block (Phase::run_block) that has begun, motion or rest. May be read by any
  // thread.
  [[nodiscard]] std::uint64_t reached_block() const noexcept {
    return reached_block_.load(std::memory_order_relaxed);
  }

  // What counts where the tool is: inputs of the machine (M52, M53), the operator's feed override.
  // May be read by any thread. As aligned as it is large: clang calls a library for an
  // atomic that is not.
  struct alignas(4) Heeded {
    bool adaptive_feed = false;
    bool feed_stop = true;
    bool feed_override = true;
  };
  [[nodiscard]] Heeded heeded() const noexcept { return heeded_.load(std::memory_order_relaxed); }

  // Of the path between the last two setpoints.
  [[nodiscard]] double chord_error_mm() const noexcept { return chord_.error_mm(place()); }
  // u of the NURBS at the last setpoint; nothing where that is on none.
  [[nodiscard]] std::optional<double> curve_parameter() const noexcept;
  // Of the block that the last setpoint is on.
  [[nodiscard]] double deviation_mm() const noexcept { return phase_.deviation_mm; }
  [[nodiscard]] bool is_at_rest() const noexcept { return v_now_mm_s_ == 0.0; }

 private:
  [[nodiscard]] double time_into_s(const Phase& phase) const noexcept;
  // Where the plan says the tool is at this tick.
  TickStatus follow_phase() noexcept;
  // Keeps where the chord to the next tick begins; once a tick.
  void begin_tick() noexcept;
  // The phase that holds the present tick. False: there was none yet.
  bool advance_phase() noexcept;
  // Applies the output changes that are in force from the begin of the present phase on.
  void advance_outputs() noexcept;
  void note_heeded() noexcept;
  // The piece of the present phase's curve that holds s_mm.
  void advance_piece(double s_mm) noexcept;
  // The line that s_mm on the present phase's curve belongs to.
  void advance_line(double s_mm) noexcept;
  void fill(const profiles::PathMotion& motion, double s_mm) noexcept;
  // interpolator_machine.cpp
  void watch_probe() noexcept;
  // What the machine is to answer while the tool rests here; null: nothing.
  [[nodiscard]] const Inquiry* question_here() noexcept;
  bool waits_for_machine() noexcept;
  void cut_piece(double s_end_mm) noexcept;
  // A tick of an emergency stop.
  TickStatus brake() noexcept;
  [[nodiscard]] TickPlace place() const noexcept {
    return {.piece = piece_, .s_mm = s_now_mm_, .position_mm = now_.position_mm};
  }

  MotionQueue* queue_;
  PlanInForce plan_;
  double period_s_;
  std::atomic<std::int64_t> plan_tick_ = 0;
  std::atomic<std::uint64_t> reached_block_ = 0;
  std::atomic<double> reached_path_mm_ = 0.0;
  std::uint64_t output_changes_ = 0;  // so many were applied
  std::atomic<bool> emergency_ = false;
  std::atomic<double> spindle_override_ = 1.0;
  double spindle_share_ = 1.0;  // of that, what was taken
  std::atomic<Heeded> heeded_{};
  EmergencyBrake brake_;
  InquiryWatch watch_;
  std::int64_t pause_ticks_ = 0;  // left, after an answer of the machine
  bool rests_for_machine_ = false;
  bool has_phase_ = false;
  bool has_next_ = false;  // of the plan in force, when the tick looked: more may come at any time
  bool tick_begun_ = false;
  Phase phase_{};
  CurvePiece piece_{};
  LineChange line_{};  // the latest that was passed
  Setpoint now_{};
  TickChord chord_;  // from the setpoint before
  double s_now_mm_ = 0.0;
  double path_begin_now_mm_ = 0.0;  // of its curve; the phase may be one ahead
  double v_now_mm_s_ = 0.0;         // along the curve, of further axes where they move alone
};

}  // namespace kerf::interp
