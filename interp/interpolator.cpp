#include "interp/interpolator.hpp"

#include <algorithm>
#include <cassert>
#include <variant>

#include "interp/axis_terms.hpp"

namespace kerf::interp {

Interpolator::Interpolator(MotionQueue& queue, double period_s, const Position& start_mm,
                           const curves::AuxiliaryPosition& start_extra_rad_mm,
                           const MachineLimits& limits) noexcept
    : queue_(&queue),
      plan_(queue),
      period_s_(period_s),
      brake_(limits, period_s),
      chord_(start_mm) {
  assert(period_s > 0.0);
  now_.tick = -1;
  now_.position_mm = start_mm;
  now_.extra_rad_mm = start_extra_rad_mm;
}

void Interpolator::begin_with(const Outputs& outputs) noexcept {
  now_.outputs = outputs;
  note_heeded();
}

double Interpolator::time_into_s(const Phase& phase) const noexcept {
  return static_cast<double>(plan_tick() - phase.begin.tick) * period_s_ - phase.begin.offset_s;
}

bool Interpolator::advance_phase() noexcept {
  for (std::size_t i = 0; i < MotionQueue::kPhases; ++i) {
    const Phase* next = plan_.next_phase();
    has_next_ = next != nullptr;
    if (!has_next_ || time_into_s(*next) < 0.0) {
      break;
    }
    phase_ = *next;
    has_phase_ = true;
    plan_.pop_phase();
    advance_outputs();
    note_heeded();
  }
  return has_phase_;
}

void Interpolator::advance_outputs() noexcept {
  for (; output_changes_ < phase_.output_changes; ++output_changes_) {
    const OutputChange* next = queue_->next_output_change();
    assert(next != nullptr);  // it was pushed before the phase
    if (next == nullptr) {
      break;
    }
    apply(*next, now_.outputs);
    queue_->pop_output_change();
  }
}

void Interpolator::note_heeded() noexcept {
  heeded_.store({.adaptive_feed = now_.outputs.follows_adaptive_feed,
                 .feed_stop = now_.outputs.heeds_feed_stop,
                 .feed_override = phase_.follows_feed},
                std::memory_order_relaxed);
}

void Interpolator::advance_piece(double s_mm) noexcept {
  for (std::size_t i = 0; i < MotionQueue::kPieces; ++i) {
    const CurvePiece* next = queue_->next_piece();
    const bool needed = next != nullptr &&
                        (piece_.curve != phase_.curve ||
                         (next->curve == phase_.curve && s_mm > curves::s_end_mm(piece_.geometry)));
    if (!needed) {
      break;
    }
    if (i > 0) {
      chord_.pass(piece_);
    }
    piece_ = *next;
    queue_->pop_piece();
  }
}

void Interpolator::advance_line(double s_mm) noexcept {
  for (std::size_t i = 0; i < MotionQueue::kLineChanges; ++i) {
    const LineChange* next = queue_->next_line_change();
    if (next == nullptr || next->curve > phase_.curve ||
        (next->curve == phase_.curve && next->s_mm > s_mm)) {
      break;
    }
    line_ = *next;
    queue_->pop_line_change();
  }
  const bool is_behind_change = phase_.has_changes && line_.curve == phase_.curve;
  now_.line = is_behind_change ? line_.line : phase_.line;
  const std::uint64_t block =
      std::max(is_behind_change ? line_.run_block : phase_.run_block, phase_.rest_block);
  if (block > reached_block()) {
    reached_block_.store(block, std::memory_order_relaxed);
  }
}

void Interpolator::fill(const profiles::PathMotion& motion, double s_mm) noexcept {
  now_.rapid = phase_.rapid;
  const bool rests = piece_.extra.alone;
  now_.v_mm_s = rests ? 0.0 : motion.v_mm_s;
  now_.a_mm_s2 = rests ? 0.0 : motion.a_mm_s2;
  now_.j_mm_s3 = rests ? 0.0 : motion.j_mm_s3;
  now_.s_mm = phase_.path_begin_mm + (rests ? 0.0 : s_mm);
  path_begin_now_mm_ = phase_.path_begin_mm;
  s_now_mm_ = s_mm;
  v_now_mm_s_ = motion.v_mm_s;
  if (phase_.curve == 0) {
    return;
  }
  assert(piece_.curve == phase_.curve);  // it was pushed before the phase
  now_.extra_rad_mm = piece_.extra.at(s_mm);
  const curves::PathDerivatives path = curves::derivatives_at(piece_.geometry, s_mm);
  now_.position_mm = path.position_mm;
  for (std::size_t k = 0; k < path.first.size(); ++k) {
    now_.velocity_mm_s[k] = path.first[k] * motion.v_mm_s;
    now_.acceleration_mm_s2[k] = axis_terms(path, k, motion).acceleration_mm_s2();
  }
}

void Interpolator::begin_tick() noexcept {
  if (tick_begun_) {
    return;
  }
  tick_begun_ = true;
  chord_.begin(place());
}

bool Interpolator::pass_what_is_over() noexcept {
  plan_.take_over(plan_tick());
  if (!advance_phase() || has_next_ || phase_.ends_at_rest ||
      time_into_s(phase_) < phase_.law.duration_s()) {
    return false;
  }
  begin_tick();
  advance_piece(phase_.s_end_mm);
  advance_line(phase_.s_end_mm);
  return true;
}

bool Interpolator::needs_plan() noexcept {
  // The next phase may begin a rounding before this one is over.
  constexpr double kRounding_s = 1e-9;
  plan_.take_over(plan_tick());
  const bool is_over = !advance_phase() ||
                       (!has_next_ && time_into_s(phase_) >= phase_.law.duration_s() - kRounding_s);
  return is_over && question_here() == nullptr;
}

TickStatus Interpolator::follow_phase() noexcept {
  assert(time_into_s(phase_) >= 0.0 && phase_.s_begin_mm <= phase_.s_end_mm);
  const double t = time_into_s(phase_);
  // With a next phase time has only rounded past the end: that phase begins before the next tick.
  const bool over = t >= phase_.law.duration_s() && !has_next_;
  profiles::PathMotion motion = phase_.law.at(t);
  double s = phase_.s_begin_mm + motion.s_mm;
  if (over || s > phase_.s_end_mm) {
    s = phase_.s_end_mm;
  }
  if (over && phase_.ends_at_rest) {
    motion = {};
  }
  advance_piece(s);
  advance_line(s);
  fill(motion, s);
  const ActiveConstraint active_constraint = over ? ActiveConstraint{} : phase_.active_constraint;
  now_.limit = motion.j_mm_s3 == 0.0 ? active_constraint.steady : active_constraint.limit;
  if (!over) {
    return TickStatus::running;
  }
  return phase_.ends_program ? TickStatus::finished
         : phase_.holds      ? TickStatus::held
         : phase_.wait != 0  ? TickStatus::waiting
                             : TickStatus::starved;
}

// Phases are passed for their lines alone.
TickStatus Interpolator::brake() noexcept {
  EmergencyBrake::Motion motion{.piece = piece_,
                                .s_mm = s_now_mm_,
                                .path_begin_mm = path_begin_now_mm_,
                                .v_mm_s = v_now_mm_s_};
  brake_.advance(motion, *queue_);
  piece_ = motion.piece;
  for (std::size_t i = 0; i < MotionQueue::kPhases; ++i) {
    const Phase* next = plan_.next_phase();
    if (next == nullptr || next->curve > piece_.curve ||
        (next->curve == piece_.curve && next->s_begin_mm >= motion.s_mm)) {
      break;  // a rest right here, and what follows it, did not come
    }
    phase_ = *next;
    plan_.pop_phase();
  }
  phase_.curve = piece_.curve;
  phase_.path_begin_mm = motion.path_begin_mm;
  advance_line(motion.s_mm);
  fill({.v_mm_s = motion.v_mm_s, .a_mm_s2 = motion.a_mm_s2}, motion.s_mm);
  now_.limit = Constraint::path_acceleration;
  now_.outputs.spindle_rad_s = 0.0;
  now_.outputs.surface = {};
  now_.outputs.mist = now_.outputs.flood = false;
  return motion.v_mm_s > 0.0 ? TickStatus::running : TickStatus::emergency_stop;
}

TickStatus Interpolator::next(Setpoint& setpoint) noexcept {
  begin_tick();
  tick_begun_ = false;
  rests_for_machine_ = false;
  ++now_.tick;
  if (is_emergency()) {
    const TickStatus braked = brake();
    setpoint = now_;  // the spindle is off
    return braked;
  }
  plan_.take_over(plan_tick());
  TickStatus status = TickStatus::starved;
  if (advance_phase()) {
    watch_probe();
    status = follow_phase();
  }
  if (status == TickStatus::running) {
    pause_ticks_ = 0;
    plan_tick_.store(plan_tick() + 1, std::memory_order_relaxed);
  } else if ((status == TickStatus::starved || status == TickStatus::waiting) &&
             waits_for_machine()) {
    status = TickStatus::running;
  }
  reached_path_mm_.store(now_.s_mm, std::memory_order_relaxed);
  follow_surface(now_.position_mm, now_.outputs);
  setpoint = now_;
  override_spindle(spindle_share_, setpoint.outputs);
  return status;
}

std::optional<double> Interpolator::curve_parameter() const noexcept {
  const auto* nurbs = std::get_if<curves::NurbsPiece>(&piece_.geometry);
  return nurbs != nullptr && piece_.curve != 0 ? std::optional(nurbs->u_at(s_now_mm_))
                                               : std::nullopt;
}

}  // namespace kerf::interp
