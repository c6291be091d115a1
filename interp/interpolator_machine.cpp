// Motion that ends where the machine says, and waits for its answer.
#include <algorithm>
#include <cmath>
#include <variant>

#include "interp/interpolator.hpp"
#include "profiles/s_curve_stop.hpp"

namespace kerf::interp {
namespace {

struct Braking {
  std::array<profiles::CellLaw, 3> law{};
  std::size_t laws = 0;
  double length_mm = 0.0;

  void add(const profiles::CellLaw& next) noexcept {
    if (next.duration_s() > 0.0) {
      law[laws++] = next;
      length_mm += next.length_mm();
    }
  }
};

// Nothing: the motion is about to rest anyway, or has to wait for a tick at which it can.
std::optional<Braking> braking_from(const profiles::PathMotion& motion,
                                    profiles::RampLimits limits) noexcept {
  Braking braking;
  if (!(motion.v_mm_s > 0.0)) {
    return braking;
  }
  limits.acceleration_mm_s2 = std::max(limits.acceleration_mm_s2, std::abs(motion.a_mm_s2));
  if (!std::isfinite(limits.jerk_mm_s3)) {
    braking.add(
        profiles::CellLaw::ramp({.v_mm_s = motion.v_mm_s, .a_mm_s2 = -limits.acceleration_mm_s2},
                                motion.v_mm_s / limits.acceleration_mm_s2));
    return braking;
  }
  const auto stop = profiles::s_curve_stop(motion, limits);
  if (!stop) {
    return std::nullopt;
  }
  for (const profiles::CellLaw& law : {stop->falling, stop->steady, stop->landing}) {
    braking.add(law);
  }
  return braking;
}

}  // namespace

// Before the present phase is followed at this tick.
void Interpolator::watch_probe() noexcept {
  const Inquiry* asked = watch_.asked();
  if (asked == nullptr || !asked->is_probe() || phase_.run_block != asked->block ||
      (!has_next_ && time_into_s(phase_) >= phase_.law.duration_s()) || !watch_.must_brake()) {
    return;
  }
  const profiles::PathMotion motion = phase_.law.at(time_into_s(phase_));
  const double s_mm = std::min(phase_.s_begin_mm + motion.s_mm, phase_.s_end_mm);
  const auto braking = braking_from(motion, asked->limits);
  const bool moves = braking && braking->laws > 0;
  if (!braking || (moves && !(s_mm + braking->length_mm < curves::s_end_mm(piece_.geometry)))) {
    return;
  }
  InquiryAnswer braked{.brake_tick = plan_tick(), .laws = braking->laws, .law = braking->law};
  braked.plan = plan_.brake(phase_, {braked.law.data(), braked.laws},
                            {.begin = {.tick = plan_tick()}, .s_mm = s_mm, .period_s = period_s_});
  watch_.brake(braked);
  advance_phase();
  cut_piece(s_mm + braking->length_mm);
}

// What lies after is not run: the next curve begins there.
void Interpolator::cut_piece(double s_end_mm) noexcept {
  auto* line = std::get_if<curves::Line>(&piece_.geometry);
  if (line != nullptr && piece_.curve == phase_.curve && s_end_mm > 0.0 &&
      s_end_mm < line->length_mm()) {
    *line = line->part({.begin_mm = 0.0, .end_mm = s_end_mm});
    chord_.cut(piece_);
  }
}

// At rest. True: the program waits here for the machine, or for the plan after its answer.
bool Interpolator::waits_for_machine() noexcept {
  const Inquiry* question = question_here();
  if (question != nullptr && watch_.wait(now_.position_mm, plan_tick())) {
    pause_ticks_ = question->pause_ticks;
  } else if (question != nullptr) {
    rests_for_machine_ = watch_.has_heard();
  } else if (pause_ticks_ > 0) {
    --pause_ticks_;
    plan_tick_.store(plan_tick() + 1, std::memory_order_relaxed);
    return true;
  }
  return question != nullptr;
}

const Inquiry* Interpolator::question_here() noexcept {
  const Inquiry* asked = watch_.asked();
  const bool is_here =
      asked != nullptr &&
      (watch_.has_braked() || (phase_.wait != 0 && phase_.rest_block == asked->block));
  return is_here ? asked : nullptr;
}

}  // namespace kerf::interp
